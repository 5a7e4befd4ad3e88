// Load factors of [ISO6336-1], edition 2006: K_V by method B, K_Hbeta by method C, K_Halpha by method B; as read in
// three open programs, with corrigendum 1 of 2008. From memory: the minimum misalignment F_betaxmin.
#pragma once

#include "calculators/gear/rating/iso_stiffness.hpp"
#include "calculators/gear/rating/iso_tolerances.hpp"

namespace loadpath::gear::rating {

/// Running-in of a deviation of pitch or profile, um, of one material: [ISO6336-1] 2006, 8.3, with corrigendum 1.
inline double profile_running_in(const Wheel& wheel, Stress lim, double f, double v) {
  if (is_hardened(wheel.material)) return std::min(0.075 * f, 3.0);
  if (wheel.material == GearMaterial::grey) return std::min(0.275 * f, v > 10.0 ? 11.0 : v > 5.0 ? 22.0 : HUGE_VAL);
  const double sigma = lim / MPa;
  const double most = v > 10.0 ? 6400.0 / sigma : v > 5.0 ? 12800.0 / sigma : HUGE_VAL;
  return std::min({160.0 / sigma * f, most, f});
}

/// The two gears with their allowable stress numbers, which decide how they run in.
struct Runners {
  const Wheel &one, &two;
  Stress lim_1, lim_2;
  [[nodiscard]] double running_in_of(double f, double v) const {
    return 0.5 * (profile_running_in(one, lim_1, f, v) + profile_running_in(two, lim_2, f, v));
  }
  /// Tip relief that running in makes, um: [ISO6336-1] 2006, 6.5.
  [[nodiscard]] double relief() const {
    const auto of = [](Stress lim) { return std::pow(lim / MPa / 97.0 - 18.45, 2.0) / 18.0 + 1.5; };
    return 0.5 * (of(lim_1) + of(lim_2));
  }
};

/// Deviations after running in, which excite vibration, and tip relief against them.
template <class Tracer>
void excitation(const Input& in, const PairResult& g, const Runners& runners, double w, Result& r, Tracer& trace) {
  const PairTolerances tolerances = tolerances_of(in, g, in.grade);
  const double alpha_t = trace.angle("alpha_t", g.alpha_t, "transverse pressure angle");
  const double v = r.v / m_per_s;
  const double f_pt = trace.value("f_pt", tolerances.f_pt(), "single pitch deviation of the grade, um, [ISO1328-1]");
  const double f_falpha = trace.value("f_falpha", tolerances.f_falpha(), "profile form deviation, um, [ISO1328-1]");
  STEP(f_pb, f_pt * cos(alpha_t), "base pitch deviation, um");
  r.y_alpha = trace.value("y_alpha", runners.running_in_of(f_pb, v) * um.one, "running-in allowance of the pitch");
  const double y_f = trace.value("y_f", runners.running_in_of(f_falpha, v), "running-in allowance of the profile, um");
  STEP_TO(r, f_pbeff, f_pb * um - r.y_alpha, "base pitch deviation after running in");
  STEP(f_feff, f_falpha - y_f, "profile form deviation after running in, um");
  const double c_prime = r.c_prime;
  STEP_TO(r, B_p, c_prime * (r.f_pbeff / um) / w, "effect of the pitch, [ISO6336-1] 2006, equation (15)");
  STEP_TO(r, B_f, c_prime * f_feff / w, "effect of the profile, [ISO6336-1] 2006, equation (16)");
  if (static_cast<int>(in.grade) > 5) {
    r.B_k = trace.value("B_k", 1.0, "effect of tip relief: none in grades 6 to 12");
    return;
  }
  const Length C_e = trace.value("C_e", is_set(in.C_a) ? in.C_a : runners.relief() * um.one,
                                 is_set(in.C_a) ? "tip relief as given" : "tip relief by running in");
  STEP_TO(r, B_k, abs(1.0 - c_prime * (C_e / um) / w), "effect of tip relief, [ISO6336-1] 2006, equation (17)");
}

template <class Tracer>
void dynamic_factor_iso(const Input& in, const PairResult& g, const Runners& runners, Result& r, Tracer& trace) {
  trace.value("u", g.u, "gear ratio");
  STEP(w, r.F_t * in.K_A / in.b / N_per_mm, "line load, N/mm");
  mesh_stiffness(in, g, w, r, trace);
  resonance(in, g, runners.one, runners.two, r, trace);
  excitation(in, g, runners, w, r, trace);
  const double eps_gamma = trace.value("eps_gamma", g.eps_gamma, "total contact ratio");
  const double N_res = r.N_res, B_p = r.B_p, B_f = r.B_f, B_k = r.B_k;
  STEP(C_v2, eps_gamma <= 2.0 ? 0.34 : 0.57 / (eps_gamma - 0.3), "constant, [ISO6336-1] 2006, table 8; C_v1 is 0.32");
  STEP(C_v3, eps_gamma <= 2.0 ? 0.23 : 0.096 / (eps_gamma - 1.56), "constant, table 8");
  STEP(C_v4, eps_gamma <= 2.0 ? 0.90 : (0.57 - 0.05 * eps_gamma) / (eps_gamma - 1.44), "constant, table 8");
  STEP(C_v6, eps_gamma <= 2.0 ? 0.47 : 0.12 / (eps_gamma - 1.74), "constant, table 8; C_v5 is 0.47");
  STEP(C_v7, 0.125 * sin(pi * (min(max(eps_gamma, 1.5), 2.5) - 2.0)) + 0.875,
       "constant, table 8: 0.75 up to 1.5, 1 from 2.5 on");
  STEP(N_S, 0.5 + 0.35 * sqrt(min(w / 100.0, 1.0)), "lower end of the main resonance, [ISO6336-1] 2006, (11), (12)");
  STEP(K_N, 1.0 + N_res * (0.32 * B_p + C_v2 * B_f + C_v3 * B_k), "below resonance, [ISO6336-1] 2006, (13), (14)");
  STEP(K_main, 1.0 + 0.32 * B_p + C_v2 * B_f + C_v4 * B_k, "main resonance, up to 1.15, [ISO6336-1] 2006, (20)");
  STEP(K_above, 0.47 * B_p + C_v6 * B_f + C_v7, "above resonance, from 1.5 on, [ISO6336-1] 2006, (21)");
  STEP(K_free,
       N_res <= N_S    ? K_N
       : N_res <= 1.15 ? K_main
                       : K_above + (K_main - K_above) * max(1.5 - N_res, 0.0) / 0.35,
       "by the range of N_res; linear from 1.15 to 1.5, [ISO6336-1] 2006, (22)");
  STEP_TO(r, K_V, max(K_free, 1.0), "dynamic factor, at least 1 on the safe side");
}

/// B_1 on the deflection and B_2 on the deviations: [ISO6336-1] 2006, 7.5.2; crowned by half of both.
inline double lead_relief(Crowning crowning) {
  return crowning == Crowning::none ? 1.0 : crowning == Crowning::crowned ? 0.5 : 0.7;
}

/// Deflection of the pinion and its shaft, by method C unless that of the shafts is given.
template <class Tracer>
void deflection_iso(const Input& in, const PairResult& g, double w_m, Result& r, Tracer& trace) {
  if (has_deflections(in)) {
    const Length f_shA = deflection_of_shafts(in, trace);
    STEP_TO(r, f_sh, r.K_V * f_shA, "equivalent misalignment due to shaft deflection under F_t K_A K_V");
    return;
  }
  const Length d_1 = trace.value("d_1", g.d_1, "reference circle of gear 1");
  const double K_p =
      trace.value("K_p", place_constant(in.place, in.stiffening), "by the position of the pinion, [ISO6336-1] 2006");
  if (K_p == 0.0) {
    STEP_TO(r, f_sh, w_m * 0.023 * pow<2>(in.b / d_1) * um,
            "equivalent misalignment due to pinion and shaft deformation, midway, [ISO6336-1] 2006, 7.5.2");
    return;
  }
  STEP_TO(r, f_sh,
          w_m * 0.023 * (abs(1.0 + K_p * in.l * in.s / (d_1 * d_1) * pow<4>(d_1 / in.d_sh) - 0.3) + 0.3) *
              pow<2>(in.b / d_1) * um,
          "equivalent misalignment due to pinion and shaft deformation, [ISO6336-1] 2006, 7.5.2");
}

/// Misalignment before running in, not below the minimum of a pair of the grade.
template <class Tracer>
void misalignment_iso(const Input& in, const PairResult& g, double w_m, Result& r, Tracer& trace) {
  const PairTolerances tolerances = tolerances_of(in, g, in.grade);
  const double B_1 = trace.value("B_1", lead_relief(in.crowning), "factor of the deflection by the lead modification");
  const Length f_Hbeta = trace.value("f_Hbeta", tolerances.f_Hbeta() * um.one, "helix slope deviation, [ISO1328-1]");
  STEP(F_betaxmin, max(0.005 * w_m * um, 0.5 * f_Hbeta), "minimum misalignment, [ISO6336-1] 2006, from memory");
  const Length f_sh = r.f_sh;
  if (in.pattern == Pattern::favourable) {
    const Length f_Hbeta5 = trace.value("f_Hbeta5", tolerances_of(in, g, 5.0).f_Hbeta() * um.one,
                                        "helix slope deviation of grade 5, [ISO1328-1]");
    STEP_TO(r, F_betax, max(abs(1.33 * B_1 * f_sh - f_Hbeta5), F_betaxmin),
            "initial equivalent misalignment, compensated, [ISO6336-1] 2006, equation (53)");
    return;
  }
  const double B_2 = trace.value("B_2", lead_relief(in.crowning), "factor of the deviations by the lead modification");
  const Length f_ma = is_set(in.f_ma) ? in.f_ma
                                      : trace.value("f_ma", tolerances.f_ma() * um.one,
                                                    "helix slope deviations of both gears, root of the sum of squares");
  STEP_TO(r, F_betax, max(1.33 * B_1 * f_sh + B_2 * f_ma, F_betaxmin),
          "initial equivalent misalignment, before running in, [ISO6336-1] 2006, 7.5.2");
}

template <class Tracer>
void face_load_factor_iso(const Input& in, const PairResult& g, const Runners& runners, Result& r, Tracer& trace) {
  STEP(w_m, r.F_t * in.K_A * r.K_V / in.b / N_per_mm, "mean line load, N/mm");
  deflection_iso(in, g, w_m, r, trace);
  misalignment_iso(in, g, w_m, r, trace);
  const double x = r.F_betax / um, v = r.v / m_per_s;
  const double y_1 = running_in(runners.one, runners.lim_1 / MPa, x, v);
  const double y_2 = running_in(runners.two, runners.lim_2 / MPa, x, v);
  r.y_beta = trace.value("y_beta", 0.5 * (y_1 + y_2) * um.one, "running-in allowance, mean of both materials");
  const Length F_betax = r.F_betax, y_beta = r.y_beta;
  STEP_TO(r, F_betay, F_betax - y_beta, "deviation after running in");
  STEP(q_H, r.c_gamma_beta * (r.F_betay / um) / (2.0 * w_m), "c_gamma_beta F_betay / (2 F_m/b)");
  STEP_TO(r, K_Hbeta, q_H < 1.0 ? 1.0 + q_H : 2.0 * sqrt(q_H),
          "face load factor; from q_H of 1 on part of the width carries, [ISO6336-1] 2006, 7.5.2");
}

/// K_Fbeta of both gears alike, from the taller tooth.
template <class Tracer>
void face_load_of_roots_iso(const Input& in, const Wheel& one, const Wheel& two, Result& r, Tracer& trace) {
  const Length h = trace.value("h", std::max(one.d_a - one.d_f, two.d_a - two.d_f) / 2.0, "depth of the taller tooth");
  STEP(h_b, h / in.b, "tooth depth over the face width");
  STEP(h_r, min(h_b, 1.0 / 3.0), "1/3 at most");
  STEP(N_F, 1.0 / (1.0 + h_r + h_r * h_r), "exponent, [ISO6336-1] 2006, 7.6");
  const double K_Hbeta = r.K_Hbeta;
  STEP_TO(r, K_Fbeta1, pow(K_Hbeta, N_F), "face load factor of the root");
  r.K_Fbeta2 = trace.value("K_Fbeta2", K_Fbeta1, "that of gear 1: one exponent for both gears");
}

/// Transverse load factors: the load shared by the teeth in contact.
template <class Tracer>
void transverse_factors_iso(const Input& in, const PairResult& g, Result& r, Tracer& trace) {
  const double eps_alpha = trace.value("eps_alpha", g.eps_alpha, "transverse contact ratio");
  const double eps_gamma = trace.value("eps_gamma", g.eps_gamma, "total contact ratio");
  STEP(w_tH, r.F_t * in.K_A * r.K_V * r.K_Hbeta / in.b / N_per_mm, "determinant line load, N/mm");
  STEP_TO(r, q_alpha, r.c_gamma_alpha * (r.f_pbeff / um) / w_tH, "c_gamma_alpha (f_pb - y_alpha) / (F_tH/b)");
  STEP(K_alpha,
       eps_gamma <= 2.0 ? eps_gamma / 2.0 * (0.9 + 0.4 * q_alpha)
                        : 0.9 + 0.4 * sqrt(2.0 * (eps_gamma - 1.0) / eps_gamma) * q_alpha,
       "transverse load factor, [ISO6336-1] 2006, 8.3.2");
  STEP_TO(r, K_Halpha, max(min(K_alpha, eps_gamma / (eps_alpha * pow<2>(r.Z_eps))), 1.0),
          "at most as one pair of teeth carries, [ISO6336-1] 2006, 8.3.4");
  STEP_TO(r, K_Falpha, max(min(K_alpha, eps_gamma / (0.25 * eps_alpha + 0.75)), 1.0),
          "at most as one pair of teeth carries, [ISO6336-1] 2006, 8.3.4");
}

}  // namespace loadpath::gear::rating
