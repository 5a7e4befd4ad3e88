// Factors of the load: dynamic, over the face width, among the teeth in contact. [DIN3990-11], 1989.
#pragma once

#include "calculators/gear/rating/wheels.hpp"

#include <array>

namespace loadpath::gear::rating {

inline constexpr int finest = 6, coarsest = 12;  // grades of DIN 3961 that the constants are given for

struct DynamicConstants {
  double spur, helical;
};
/// K_1 by the grade, [DIN3990-11] table; K_2 0.0193 and 0.0087.
inline DynamicConstants dynamic_constants(int grade) {
  constexpr std::array<DynamicConstants, 7> rows{
      {{9.6, 8.5}, {15.3, 13.6}, {24.5, 21.8}, {34.5, 30.7}, {53.6, 47.7}, {76.6, 68.2}, {122.5, 109.1}}};
  return rows[static_cast<std::size_t>(std::min(std::max(grade, finest), coarsest) - finest)];
}

template <class Tracer>
void dynamic_factor(const Input& in, const PairResult& g, Result& r, Tracer& trace) {
  const auto [K_spur, K_helical] = dynamic_constants(static_cast<int>(in.grade));
  const double u = trace.value("u", g.u, "gear ratio");
  const Force F_t = r.F_t;
  STEP(w, max(F_t * in.K_A / in.b / N_per_mm, 100.0), "line load, N/mm; 100 at least");
  STEP_TO(r, x_v, in.z_1 * (r.v / m_per_s) / 100.0 * sqrt(u * u / (1.0 + u * u)), "pitch line velocity, related");
  trace.value("K_1s", K_spur, "constant of the grade, spur gears");
  trace.value("K_1h", K_helical, "constant of the grade, helical gears");
  const double K_1s = K_spur, K_1h = K_helical;
  STEP(K_Vs, 1.0 + (K_1s / w + 0.0193) * x_v, "spur gears, [DIN3990-11]");
  if (g.eps_beta <= 0.0) {
    r.K_V = trace.value("K_V", K_Vs, "spur gears");
    return;
  }
  const double eps_beta = trace.value("eps_beta", g.eps_beta, "overlap ratio");
  STEP(K_Vh, 1.0 + (K_1h / w + 0.0087) * x_v, "helical gears with an overlap ratio of 1 or more, [DIN3990-11]");
  STEP_TO(r, K_V, K_Vs - min(eps_beta, 1.0) * (K_Vs - K_Vh), "linear in the overlap ratio below 1");
}

/// K' of the place of the pinion, without and with a stiffening body, [DIN3990-11] figure 3.2; 0 midway.
inline double place_constant(Place place, Stiffening stiffening) {
  const bool stiff = stiffening == Stiffening::pinion;
  switch (place) {
    case Place::a:
      return stiff ? 0.48 : 0.8;
    case Place::b:
      return stiff ? -0.48 : -0.8;
    case Place::c:
      return 1.33;
    case Place::d:
      return stiff ? -0.36 : -0.6;
    case Place::e:
      return stiff ? -0.6 : -1.0;
    case Place::untold:
    case Place::middle:
      break;
  }
  return 0.0;
}

/// Running-in allowance of one material, um: [DIN3990-11].
inline double running_in(const Wheel& wheel, double sigma_Hlim, double F_betax, double v) {
  if (is_hardened(wheel.material)) return std::min(0.15 * F_betax, 6.0);
  if (wheel.material == GearMaterial::grey)
    return std::min(0.55 * F_betax, v > 10.0 ? 22.0 : v > 5.0 ? 45.0 : HUGE_VAL);
  const double most = v > 10.0 ? 12800.0 / sigma_Hlim : v > 5.0 ? 25600.0 / sigma_Hlim : HUGE_VAL;
  return std::min({320.0 / sigma_Hlim * F_betax, most, F_betax});
}

/// f_Hbeta of ISO 1328-1:1995 for the grade and the larger gear.
inline Length helix_tolerance(const Input& in, const PairResult& g) {
  const double d = std::max(g.d_1, g.d_2) / mm, width = in.b / mm;
  const double at_5 = 0.07 * std::sqrt(d) + 0.45 * std::sqrt(width) + 3.0;
  return at_5 * std::pow(2.0, 0.5 * (static_cast<double>(in.grade) - 5.0)) * um.one;
}

template <class Tracer>
Length manufacturing_deviation(const Input& in, const PairResult& g, Tracer& trace) {
  if (is_set(in.f_ma)) return in.f_ma;
  return trace.value("f_ma", helix_tolerance(in, g),
                     "helix slope tolerance of the grade, ISO 1328-1:1995, not checked against the source");
}

/// Deflection of the pinion and its shaft, by method C unless that of the shafts is given.
template <class Tracer>
void deflection(const Input& in, const PairResult& g, double w_m, Result& r, Tracer& trace) {
  const double A = trace.value("A",
                               in.crowning == Crowning::none      ? 0.023
                               : in.crowning == Crowning::crowned ? 0.012
                                                                  : 0.016,
                               "by the lead modification, [DIN3990-11]");
  if (has_deflections(in)) {
    const Length f_shA = deflection_of_shafts(in, trace);
    STEP_TO(r, f_sh, A / 0.023 * r.K_V * f_shA,
            "equivalent misalignment due to shaft deflection under F_t K_A K_V, by the lead modification");
    return;
  }
  const Length d_1 = g.d_1;
  const double K_p =
      trace.value("K_p", place_constant(in.place, in.stiffening), "by the position of the pinion, [DIN3990-11]");
  if (K_p == 0.0) {
    STEP_TO(r, f_sh, w_m * A * pow<2>(in.b / d_1) * um,
            "equivalent misalignment due to pinion and shaft deformation, midway");
  } else {
    STEP_TO(r, f_sh,
            w_m * A * (abs(1.0 + K_p * in.l * in.s / (d_1 * d_1) * pow<4>(d_1 / in.d_sh) - 0.3) + 0.3) *
                pow<2>(in.b / d_1) * um,
            "equivalent misalignment due to pinion and shaft deformation, [DIN3990-11]");
  }
}

template <class Tracer>
void face_load_factor(const Input& in, const PairResult& g, const Wheel& one, const Wheel& two, Stress lim_1,
                      Stress lim_2, Result& r, Tracer& trace) {
  trace.value("d_1", g.d_1, "reference circle of gear 1");
  STEP(w_m, r.F_t * in.K_A * r.K_V / in.b / N_per_mm, "mean line load, N/mm");
  deflection(in, g, w_m, r, trace);
  const Length f_sh = r.f_sh;
  const Length f_ma = manufacturing_deviation(in, g, trace);
  if (in.pattern == Pattern::favourable) {
    STEP_TO(r, F_betax, abs(1.33 * f_sh - f_ma), "initial equivalent misalignment, compensated");
  } else {
    STEP_TO(r, F_betax, 1.33 * f_sh + f_ma, "initial equivalent misalignment, before running in");
  }
  const double x = r.F_betax / um, v = r.v / m_per_s;
  const double y_1 = running_in(one, lim_1 / MPa, x, v), y_2 = running_in(two, lim_2 / MPa, x, v);
  r.y_beta = trace.value("y_beta", 0.5 * (y_1 + y_2) * um.one, "running-in allowance, mean of both materials");
  const Length F_betax = r.F_betax, y_beta = r.y_beta;
  STEP(F_betay, F_betax - y_beta, "deviation after running in");
  STEP(q_H, 20.0 * (F_betay / um) / w_m, "c_gamma F_betay / (F_m/b), with c_gamma of 20 N/(mm um)");
  r.K_Hbeta = q_H <= 2.0
                  ? NAMED_STEP("K_Hbeta", 1.0 + q_H / 2.0, "face load factor, [DIN3990-11]")
                  : NAMED_STEP("K_Hbeta", sqrt(2.0 * q_H), "face load factor, part of the width carries, [DIN3990-11]");
}

/// K_Fbeta of one gear, from the height of its teeth.
template <class Tracer>
double face_load_of_root(const Input& in, const Wheel& wheel, const Result& r, Tracer& trace) {
  const Length d_a = trace.value("d_a", wheel.d_a, "tip circle"), d_f = trace.value("d_f", wheel.d_f, "root circle");
  STEP(h_b, (d_a - d_f) / (2.0 * in.b), "tooth depth over the face width");
  STEP(h_r, min(h_b, 1.0 / 3.0), "1/3 at most");
  STEP(N_F, 1.0 / (1.0 + h_r + h_r * h_r), "exponent");
  return trace.value(wheel.symbols.K_Fbeta, std::pow(r.K_Hbeta, N_F),
                     "K_Hbeta^N_F, face load factor of the root, [DIN3990-11]");
}

/// Factors among the teeth: of the grade; where teeth are not hardened, those of hardened spur teeth, on the safe side.
template <class Tracer>
void transverse_factors(const Input& in, const PairResult& g, bool hardened, Result& r, Tracer& trace) {
  const bool light = r.F_t * in.K_A / in.b <= 100.0 * N_per_mm.one, spur = in.beta == 0.0;
  const int grade = static_cast<int>(in.grade);
  const double eps_alpha = trace.value("eps_alpha", g.eps_alpha, "transverse contact ratio");
  double of_grade = 1.0;
  bool coarse = light;
  if (spur) {
    of_grade = grade <= 7 ? 1.0 : grade == 8 ? 1.1 : 1.2;
    coarse = coarse || grade > 9;
  } else if (hardened) {
    of_grade = grade <= 6 ? 1.0 : grade == 7 ? 1.1 : grade == 8 ? 1.2 : 1.4;
    coarse = coarse || grade > 9;
  } else {
    of_grade = grade <= 7 ? 1.0 : grade == 8 ? 1.1 : grade == 9 ? 1.2 : 1.4;
    coarse = coarse || grade > 10;
  }
  if (!coarse) {
    r.K_Halpha = trace.value("K_Halpha", of_grade, "transverse load factor of the grade, [DIN3990-11]");
    r.K_Falpha = trace.value("K_Falpha", of_grade, "the same");
  } else if (spur) {
    STEP_TO(r, K_Halpha, max(1.0 / pow<2>(r.Z_eps), 1.2), "one pair of teeth carries, [DIN3990-11]");
    STEP_TO(r, K_Falpha, max(1.0 / r.Y_eps, 1.2), "one pair of teeth carries, [DIN3990-11]");
  } else {
    const double beta_b = trace.angle("beta_b", std::acos(cos_of_base_helix(in, g)), "base helix angle");
    STEP_TO(r, K_Halpha, max(eps_alpha / pow<2>(cos(beta_b)), 1.4), "coarse helical teeth, [DIN3990-11]");
    STEP_TO(r, K_Falpha, max(eps_alpha / pow<2>(cos(beta_b)), 1.4), "coarse helical teeth, [DIN3990-11]");
  }
}

}  // namespace loadpath::gear::rating
