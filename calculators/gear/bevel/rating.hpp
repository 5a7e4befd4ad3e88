// Pitting and tooth breakage of gear.bevel by ANSI/AGMA 2003. Its formulas are in inches, psi and ft/min.
#pragma once

#include "calculators/gear/bevel/types.hpp"
#include "lib/calculator/trace.hpp"

namespace loadpath::gear::bevel {

inline double mounting_factor(BevelTypes::Mounting mounting) {
  return mounting == BevelTypes::Mounting::both_straddled  ? 1.0
         : mounting == BevelTypes::Mounting::one_straddled ? 1.1
                                                           : 1.25;
}

template <class Tracer>
void load_factors(const BevelTypes::Input& in, BevelTypes::Result& r, Tracer& trace) {
  using Crowning = BevelTypes::Crowning;
  STEP(v_f, r.v_e / (0.00508 * m_per_s), "pitch line velocity in ft/min");
  STEP(B, 0.25 * pow(12.0 - in.Q_v, 2.0 / 3.0), "exponent of the accuracy number, [AGMA2003]");
  STEP(A, 50.0 + 56.0 * (1.0 - B), "[AGMA2003]");
  STEP_TO(r, K_v, pow((A + sqrt(v_f)) / A, B), "[AGMA2003]");
  STEP_TO(r, x_v, v_f / pow<2>(A + in.Q_v - 3.0), "the dynamic factor holds up to this velocity");
  STEP(P_d, 25.4 * mm / in.m_et, "diametral pitch, 1/in");
  STEP_TO(r, K_s, P_d > 16.0 ? 0.5 : 0.4867 + 0.2132 / P_d, "[AGMA2003]");
  STEP(b_i, in.b / (25.4 * mm), "face width in inches");
  const double K_mb = trace.value("K_mb", mounting_factor(in.mounting), "by the mounting, [AGMA2003]");
  STEP_TO(r, K_m, K_mb + 0.0036 * pow<2>(b_i), "[AGMA2003]");
  STEP_TO(r, C_s, min(1.0, max(0.5, 0.125 * b_i + 0.4375)), "[AGMA2003]");
  STEP_TO(r, C_xc, in.crowning == Crowning::crowned ? 1.5 : 2.0, "[AGMA2003]");
  STEP_TO(r, C_p,
          sqrt(1.0 / (pi * ((1.0 - pow<2>(in.nu_1)) / (in.E_1 / MPa) + (1.0 - pow<2>(in.nu_2)) / (in.E_2 / MPa)))),
          "cylinders in contact, [AGMA2003]");
}

/// Symbols of the factors of a gear.
struct LifeSymbols {
  const char *C_L, *K_L;
};
struct LifeFactors {
  double C_L, K_L;
};

template <class Tracer>
LifeFactors life_factors(const BevelTypes::Input& in, double cycles, const LifeSymbols& symbols, Tracer& trace) {
  const double N_L = trace.value("N_L", cycles, "load cycles of this gear");
  const double C_L = NAMED_STEP(symbols.C_L, N_L < 1e4 ? 2.0 : 3.4822 * pow(N_L, -0.0602), "[AGMA2003]");
  if (N_L < 1e3) return {C_L, trace.value(symbols.K_L, 2.7, "below 1000 cycles, [AGMA2003]")};
  if (N_L < 3e6) return {C_L, NAMED_STEP(symbols.K_L, 6.1514 * pow(N_L, -0.1192), "[AGMA2003]")};
  if (in.service == BevelTypes::Service::critical)
    return {C_L, NAMED_STEP(symbols.K_L, 1.683 * pow(N_L, -0.0323), "critical service, [AGMA2003]")};
  return {C_L, NAMED_STEP(symbols.K_L, 1.3558 * pow(N_L, -0.0178), "general service, [AGMA2003]")};
}

template <class Tracer>
void strength_factors(const BevelTypes::Input& in, BevelTypes::Result& r, Tracer& trace) {
  if (is_set(in.L_h)) {
    STEP_TO(r, N_1, in.n_1 * in.L_h / (2.0 * pi), "revolutions during the life");
  } else {
    STEP_TO(r, N_1, in.N, "as given");
  }
  STEP_TO(r, N_2, r.N_1 / r.i, "fewer by the gear ratio");
  const LifeFactors one = life_factors(in, r.N_1, {"C_L1", "K_L1"}, trace);
  const LifeFactors two = life_factors(in, r.N_2, {"C_L2", "K_L2"}, trace);
  r.C_L1 = one.C_L, r.K_L1 = one.K_L, r.C_L2 = two.C_L, r.K_L2 = two.K_L;
  STEP(lg_R, log(1.0 - in.R) / log(10.0), "share of failures, logarithm to the base 10");
  STEP_TO(r, K_R, in.R < 0.99 ? 0.7 - 0.15 * lg_R : 0.5 - 0.25 * lg_R, "[AGMA2003]");
  STEP_TO(r, C_R, sqrt(K_R), "[AGMA2003]");
  if (is_set(in.T_G)) {
    STEP(t_F, 1.8 * in.T_G / kelvin - 459.67, "temperature in deg F");
    STEP_TO(r, K_T, t_F > 250.0 ? (460.0 + t_F) / 710.0 : 1.0, "[AGMA2003]");
  } else {
    r.K_T = trace.value("K_T", 1.0, "up to 121 °C (250 °F), [AGMA2003]");
  }
}

/// Allowable stress numbers of a gear at 1e7 cycles, as given or by its hardness.
template <class Tracer>
Stress contact_number(const char* symbol, Stress given, double hardness, Tracer& trace) {
  if (is_set(given)) return trace.value(symbol, given, "as given");
  const double H_B = trace.value("H_B", hardness, "Brinell hardness of this gear");
  return NAMED_STEP(symbol, (341.0 * H_B + 23620.0) * 0.00689476 * MPa, "through-hardened steel, grade 1, [AGMA2003]");
}
template <class Tracer>
Stress bending_number(const char* symbol, Stress given, double hardness, Tracer& trace) {
  if (is_set(given)) return trace.value(symbol, given, "as given");
  const double H_B = trace.value("H_B", hardness, "Brinell hardness of this gear");
  return NAMED_STEP(symbol, (44.0 * H_B + 2100.0) * 0.00689476 * MPa, "through-hardened steel, grade 1, [AGMA2003]");
}

template <class Tracer>
void rate_pitting(const BevelTypes::Input& in, BevelTypes::Result& r, Tracer& trace) {
  if (!is_set(in.I)) return;
  STEP_TO(r, s_c, r.C_p * sqrt(r.W_t * in.K_A * r.K_v * r.K_m * r.C_s * r.C_xc / (in.b * r.d_1 * in.I) / MPa) * MPa,
          "[AGMA2003]");
  const Stress s_c1 = contact_number("s_c1", in.s_ac1, in.H_B1, trace);
  STEP_TO(r, s_wc1, s_c1 * r.C_L1 / (r.K_T * r.C_R), "[AGMA2003]");
  const Stress s_c2 = contact_number("s_c2", in.s_ac2, in.H_B2, trace);
  STEP_TO(r, s_wc2, s_c2 * r.C_L2 * in.C_H / (r.K_T * r.C_R), "[AGMA2003]");
  STEP_TO(r, S_H1, s_wc1 / s_c, "safety factor in stress");
  STEP_TO(r, S_H2, s_wc2 / s_c, "safety factor in stress");
  if (!is_set(in.S_Hmin)) return;
  STEP_TO(r, u_H1, in.S_Hmin / S_H1, "required over calculated safety factor");
  STEP_TO(r, u_H2, in.S_Hmin / S_H2, "required over calculated safety factor");
}

inline constexpr const char* why_idler = "reversed bending: 70 % for an idler gear";

template <class Tracer>
void rate_bending(const BevelTypes::Input& in, BevelTypes::Result& r, Tracer& trace) {
  STEP(s_0, r.W_t / (in.b * in.m_et) * in.K_A * r.K_v * r.K_s * r.K_m, "bending stress times the geometry factor");
  if (is_set(in.J_1)) {
    STEP_TO(r, s_t1, s_0 / in.J_1, "straight teeth, [AGMA2003]");
    const Stress s_b1 = bending_number("s_b1", in.s_at1, in.H_B1, trace);
    const double Y_A1 = trace.value("Y_A1", is_idler(in.idler, Idler::gear_1) ? 0.7 : 1.0, why_idler);
    STEP_TO(r, s_wt1, Y_A1 * s_b1 * r.K_L1 / (r.K_T * r.K_R), "[AGMA2003]");
    STEP_TO(r, S_F1, s_wt1 / s_t1, "safety factor in stress");
    if (is_set(in.S_Fmin)) {
      STEP_TO(r, u_F1, in.S_Fmin / S_F1, "required over calculated safety factor");
    }
  }
  if (is_set(in.J_2)) {
    STEP_TO(r, s_t2, s_0 / in.J_2, "straight teeth, [AGMA2003]");
    const Stress s_b2 = bending_number("s_b2", in.s_at2, in.H_B2, trace);
    const double Y_A2 = trace.value("Y_A2", is_idler(in.idler, Idler::gear_2) ? 0.7 : 1.0, why_idler);
    STEP_TO(r, s_wt2, Y_A2 * s_b2 * r.K_L2 / (r.K_T * r.K_R), "[AGMA2003]");
    STEP_TO(r, S_F2, s_wt2 / s_t2, "safety factor in stress");
    if (is_set(in.S_Fmin)) {
      STEP_TO(r, u_F2, in.S_Fmin / S_F2, "required over calculated safety factor");
    }
  }
}

}  // namespace loadpath::gear::bevel
