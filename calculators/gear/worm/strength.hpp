// Friction, rated force, bending and heat of gear.worm. The formulas of AGMA are in inches, pounds and ft/min.
#pragma once

#include "calculators/gear/worm/types.hpp"
#include "lib/calculator/trace.hpp"

namespace loadpath::gear::worm_gear {

using Input = WormTypes::Input;
using Result = WormTypes::Result;

template <class Tracer>
double sliding_in_feet(const Result& r, Tracer& trace) {
  return NAMED_STEP("v_f", r.v_s / (0.00508 * m_per_s), "sliding velocity in ft/min");
}

template <class Tracer>
double friction(const Input& in, const Result& r, Tracer& trace) {
  if (is_set(in.mu)) return trace.value("mu", in.mu, "as given");
  const double v_f = sliding_in_feet(r, trace);
  if (v_f < 10.0) return NAMED_STEP("mu", 0.124 * exp(-0.074 * pow(v_f, 0.645)), "below 10 ft/min, [AGMA6034]");
  return NAMED_STEP("mu", 0.103 * exp(-0.110 * pow(v_f, 0.450)) + 0.012, "from 10 ft/min on, [AGMA6034]");
}

template <class Tracer>
double materials_factor(WormTypes::Casting casting, double D_G, Tracer& trace) {
  using Casting = WormTypes::Casting;
  STEP(lg_D, log(D_G) / log(10.0), "its logarithm to the base 10");
  if (casting == Casting::sand)
    return NAMED_STEP("C_s0", min(1000.0, 1190.0 - 477.0 * lg_D), "sand-cast bronze, [AGMA6034]");
  if (casting == Casting::chill)
    return NAMED_STEP("C_s0", min(1000.0, 1412.0 - 456.0 * lg_D), "chill-cast bronze, [AGMA6034]");
  return NAMED_STEP("C_s0", min(1000.0, 1251.0 - 180.0 * lg_D), "centrifugally cast bronze, [AGMA6034]");
}

template <class Tracer>
double ratio_factor(double ratio_of_teeth, Tracer& trace) {
  const double m_G = trace.value("m_G", ratio_of_teeth, "gear ratio");
  // Beyond 76 the difference under the first root would be negative, below 3 that of the second formula holds no more.
  if (m_G < 3.0 || m_G > 100.0) return unset<double>;
  if (m_G <= 20.0)
    return NAMED_STEP("C_m", 0.02 * sqrt(40.0 * m_G - pow<2>(m_G) - 76.0) + 0.46, "up to 20, [AGMA6034]");
  if (m_G <= 76.0) return NAMED_STEP("C_m", 0.0107 * sqrt(56.0 * m_G - pow<2>(m_G) + 5145.0), "20 to 76, [AGMA6034]");
  return NAMED_STEP("C_m", 1.1483 - 0.00658 * m_G, "above 76, [AGMA6034]");
}

template <class Tracer>
double velocity_factor(const Result& r, Tracer& trace) {
  const double v_f = sliding_in_feet(r, trace);
  if (v_f < 700.0) return NAMED_STEP("C_v", 0.659 * exp(-0.0011 * v_f), "below 700 ft/min, [AGMA6034]");
  if (v_f < 3000.0) return NAMED_STEP("C_v", 13.31 * pow(v_f, -0.571), "700 to 3000 ft/min, [AGMA6034]");
  return NAMED_STEP("C_v", 65.52 * pow(v_f, -0.774), "from 3000 ft/min on, [AGMA6034]");
}

template <class Tracer>
void rate_wear(const Input& in, Result& r, Tracer& trace) {
  if (in.casting == WormTypes::Casting::unsaid || !is_set(r.v_s)) return;
  STEP(D_G, r.d_2 / (25.4 * mm), "reference diameter of the wheel in inches");
  const double C_s0 = materials_factor(in.casting, D_G, trace);
  STEP(a_i, r.a / (25.4 * mm), "centre distance in inches");
  STEP_TO(r, C_s, a_i < 3.0 ? min(C_s0, 720.0 + 10.37 * pow<3>(a_i)) : C_s0,
          "small gears, [EngineersEdge-worm], [Shigley-15-32]");
  STEP_TO(r, x_i, r.i, "the ratio correction factor is given for these");
  r.C_m = ratio_factor(r.i, trace);
  r.C_v = velocity_factor(r, trace);
  STEP_TO(r, x_s, r.v_s / (30.0 * m_per_s), "6000 ft/min");
  STEP_TO(r, x_n, in.n_1 / (3600.0 * rpm), "range of speeds, from memory of AGMA 6034");
  if (!is_set(r.C_m)) return;
  STEP(F_i, r.F_e / (25.4 * mm), "effective face width in inches");
  STEP_TO(r, W_tR, 4.44822 * C_s * pow(D_G, 0.8) * F_i * r.C_m * r.C_v * N, "[AGMA6034], in pounds");
  if (!is_set(r.F_t2)) return;
  STEP_TO(r, S_W, W_tR / (in.K_A * r.F_t2), "rated over tangential force");
  if (!is_set(in.S_Wmin)) return;
  STEP_TO(r, u_W, in.S_Wmin / S_W, "required over calculated safety factor");
}

template <class Tracer>
double form_factor(const Input& in, Tracer& trace) {
  STEP(alpha_d, in.alpha_n / deg, "pressure angle in degrees");
  return NAMED_STEP("y", alpha_d < 20.0 ? 0.1 + 0.025 * (alpha_d - 14.5) / 5.5 : 0.125 + 0.005 * (alpha_d - 20.0),
                    "0.100, 0.125, 0.150, 0.175 at 14.5, 20, 25, 30°, [AGMA6034]");
}

template <class Tracer>
void bend(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(r.F_t2) || !is_set(r.v_2)) return;
  if (is_set(in.y)) {
    STEP_TO(r, y, in.y, "as given");
  } else {
    r.y = form_factor(in, trace);
  }
  STEP(v_G, r.v_2 / (0.00508 * m_per_s), "pitch line velocity of the wheel in ft/min");
  STEP_TO(r, K_v, (1200.0 + v_G) / 1200.0, "[AGMA6034]");
  STEP(p_n, r.p_x * cos(r.gamma), "normal pitch");
  STEP_TO(r, sigma_F, in.K_A * K_v * r.F_t2 / (r.y * r.F_e * p_n), "Buckingham, [AGMA6034]");
  if (!is_set(in.sigma_adm)) return;
  STEP_TO(r, u_F, sigma_F / in.sigma_adm, "bending of the wheel teeth");
}

/// Heat transfer recalled from AGMA: n/6494 + 0.13, with a fan n/3939 + 0.13 ft lbf/(min in^2 deg F), by 63.05 in
/// W/(m^2 K).
template <class Tracer>
void balance_heat(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(r.P_V)) return;
  if (is_set(in.P_cool)) {
    STEP_TO(r, P_K, in.P_cool, "as given");
    STEP_TO(r, u_T, r.P_V / P_K, "balance of heat");
    return;
  }
  if (!is_set(in.A_h) || !is_set(in.dT_adm)) return;
  STEP(n_h, in.n_1 / rpm, "speed of the worm in rpm");
  const bool blown = in.cooling == WormTypes::Cooling::fan;
  const double k_h = blown ? NAMED_STEP("k_h", 63.05 * (n_h / 3939.0 + 0.13), "W/(m^2 K), with a fan, from memory")
                           : NAMED_STEP("k_h", 63.05 * (n_h / 6494.0 + 0.13), "W/(m^2 K), without a fan, from memory");
  STEP(A_m, in.A_h / (1e6 * mm2), "surface in m^2");
  STEP_TO(r, P_K, k_h * A_m * (in.dT_adm / kelvin) * W, "heat through the case");
  STEP_TO(r, dT, r.P_V / P_K * in.dT_adm, "proportional to the power loss");
  STEP_TO(r, u_T, r.P_V / P_K, "balance of heat");
}

}  // namespace loadpath::gear::worm_gear
