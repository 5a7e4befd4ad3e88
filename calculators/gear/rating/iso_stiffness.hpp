// Stiffness of a mesh by [ISO6336-1], edition 2006, clause 9, method B, for the load factors of ISO 6336.
#pragma once

#include "calculators/gear/rating/load_factors.hpp"

namespace loadpath::gear::rating {

/// Whether gear 1 is the pinion: fewer teeth, of two alike the larger profile shift.
inline bool is_pinion_first(const Input& in, const PairResult& g) {
  const double z_1 = in.z_1, z_2 = in.z_2;
  return z_1 < z_2 || (z_1 <= z_2 && in.x_1 >= g.x_2);
}

/// Series of the flexibility of a pair of teeth.
template <class Tracer>
double flexibility(const Input& in, const PairResult& g, Tracer& trace) {
  const bool first = is_pinion_first(in, g);
  const double beta_b = trace.angle("beta_b", std::acos(cos_of_base_helix(in, g)), "base helix angle");
  const double z_1 = in.z_1, z_2 = in.z_2;
  const double z_p = trace.value("z_p", first ? z_1 : z_2, "teeth of the pinion");
  const double z_w = trace.value("z_w", first ? z_2 : z_1, "teeth of the wheel");
  const double x_p = trace.value("x_p", first ? in.x_1 : g.x_2, "profile shift of the pinion");
  const double x_w = trace.value("x_w", first ? g.x_2 : in.x_1, "profile shift of the wheel");
  STEP(z_np, z_p / (pow<2>(cos(beta_b)) * cos(in.beta)), "teeth of the virtual spur gear, pinion");
  STEP(z_nw, z_w / (pow<2>(cos(beta_b)) * cos(in.beta)), "teeth of the virtual spur gear, wheel");
  return NAMED_STEP("q_c",
                    0.04723 + 0.15551 / z_np + 0.25791 / z_nw - 0.00635 * x_p - 0.11654 * x_p / z_np - 0.00193 * x_w -
                        0.24188 * x_w / z_nw + 0.00529 * x_p * x_p + 0.00182 * x_w * x_w,
                    "flexibility of a pair of teeth, mm um/N, [ISO6336-1] 2006, clause 9");
}

/// Solid gears; the mesh of soft materials by their moduli, that of a light load by its fourth root.
template <class Tracer>
void mesh_stiffness(const Input& in, const PairResult& g, double w, Result& r, Tracer& trace) {
  const double q_c = flexibility(in, g, trace);
  STEP_TO(r, c_th, 1.0 / q_c, "theoretical single stiffness, N/(mm um)");
  const double E_1 = modulus_of(in.material_1), E_2 = modulus_of(in.material_2);
  const double E_r = trace.value("E_r", 2.0 * E_1 * E_2 / (E_1 + E_2) / modulus_of(GearMaterial::steel),
                                 "modulus of both materials over that of steel");
  STEP(C_B, (1.0 + 0.5 * (1.2 - in.h_fP)) * (1.0 - 3.6 * (pi / 9.0 - in.alpha_n) / pi),
       "factor of the basic rack, 0.02 for each degree below 20, [ISO6336-1] 2006, Cor. 1");
  STEP_TO(r, c_prime, r.c_th * 0.8 * C_B * E_r * cos(in.beta) * pow(min(w / 100.0, 1.0), 0.25),
          "single stiffness with C_M of 0.8 and C_R of 1, below 100 N/mm by the fourth root of the load");
  const double eps_alpha = trace.value("eps_alpha", g.eps_alpha, "transverse contact ratio");
  STEP_TO(r, c_gamma_alpha, r.c_prime * (0.75 * eps_alpha + 0.25), "mesh stiffness, [ISO6336-1] 2006, clause 9");
  STEP_TO(r, c_gamma_beta, 0.85 * r.c_gamma_alpha, "mesh stiffness for the face load factor");
  r.x_c = trace.value("x_c", in.x_1 + g.x_2, "sum of the profile shifts: range of the series");
}

/// 1 - q^4 of a gear with a bore within its rim; 1 of a solid one.
inline double hollow(const Wheel& wheel) {
  if (!is_set(wheel.s_R)) return 1.0;
  const double q = (wheel.d_f - 2.0 * wheel.s_R) / (0.5 * (wheel.d_a + wheel.d_f));
  return 1.0 - std::pow(std::max(q, 0.0), 4.0);
}

/// Ratio of the speed to that of resonance.
template <class Tracer>
void resonance(const Input& in, const PairResult& g, const Wheel& one, const Wheel& two, Result& r, Tracer& trace) {
  const bool first = is_pinion_first(in, g);
  const Wheel &pinion = first ? one : two, &wheel = first ? two : one;
  const double u_p = trace.value("u_p", wheel.z / pinion.z, "teeth of the wheel over those of the pinion");
  const Length d_ap = trace.value("d_ap", pinion.d_a, "tip circle of the pinion");
  const Length d_fp = trace.value("d_fp", pinion.d_f, "its root circle");
  const Length d_bp = trace.value("d_bp", pinion.d_b, "its base circle");
  const double A_p = trace.value("A_p", hollow(pinion), "1 - q^4 of the pinion, 1 of a solid one");
  const double A_w = trace.value("A_w", hollow(wheel), "1 - q^4 of the wheel");
  STEP(d_mp, (d_ap + d_fp) / 2.0, "mean diameter");
  STEP(m_red, pi / 8.0 * pow<2>(d_mp / d_bp) * pow<2>(d_mp / mm) * 7.83e-6 / (1.0 / A_p + 1.0 / (A_w * u_p * u_p)),
       "reduced mass of gears of steel, kg/mm, [ISO6336-1] 2006, equation (30)");
  STEP(n_E1, 30000.0 / (pi * in.z_1) * sqrt(r.c_gamma_alpha / m_red),
       "resonance speed of gear 1, rpm, [ISO6336-1] 2006, equation (6)");
  STEP_TO(r, N_res, abs(in.n_1) / rpm / n_E1, "resonance ratio N, [ISO6336-1] 2006, equation (9)");
}

}  // namespace loadpath::gear::rating
