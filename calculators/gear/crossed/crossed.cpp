#include "calculators/gear/crossed/crossed.hpp"

#include "calculators/gear/crossed/geometry.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <cmath>

namespace loadpath::gear {

namespace crossed {

/// Speeds and efficiencies. Friction acts along the teeth; its share of the forces changes sign with that of Sigma.
template <class Tracer>
void slide(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.n_1)) {
    STEP_TO(r, n_2, in.n_1 / r.i, "ratio of the teeth");
    STEP_TO(r, v_1, in.n_1 * r.d_1 / 2.0, "at the reference diameter");
    STEP_TO(r, v_2, n_2 * r.d_2 / 2.0, "at the reference diameter");
    STEP_TO(r, v_s, v_1 * abs(sin(r.Sigma)) / cos(in.beta_2), "velocities across the teeth are equal");
  }
  const double q = trace.value("q", r.Sigma < 0.0 ? -1.0 : 1.0, "sign of Sigma: direction of sliding");
  STEP(f_1, q * in.mu * tan(in.beta_1) / cos(in.alpha_n), "friction over driving force, gear 1");
  STEP(f_2, q * in.mu * tan(in.beta_2) / cos(in.alpha_n), "friction over driving force, gear 2");
  STEP_TO(r, eta, (1.0 - f_2) / (1.0 + f_1), "gear 1 drives, [Spiral-gears]");
  STEP_TO(r, eta_b, (1.0 - f_1) / (1.0 + f_2), "gear 2 drives: friction is reversed");
  if (in.locking != CrossedTypes::Locking::required) return;
  STEP_TO(r, x_L, f_1, "gear 2 does not turn gear 1");
}

/// Loads on the shafts, with K_A. `w`: 1 where gear 1 turns counter-clockwise, else -1.
inline void hand_over(const Input& in, double w, Result& r) {
  const double K_A = in.K_A;
  r.gear_1 = shaft_load(K_A * r.T_1, {-K_A * r.F_r, r.F_y1, r.F_z1}, r.d_1, w * in.n_1);
  r.gear_2 = shaft_load(K_A * r.T_2, {-K_A * r.F_r, r.F_y2, r.F_z2}, r.d_2, -w * r.n_2);
  r.gear_1.d_f = r.d_f1, r.gear_1.h_t = (r.d_a1 - r.d_f1) / 2.0;
  r.gear_2.d_f = r.d_f2, r.gear_2.h_t = (r.d_a2 - r.d_f2) / 2.0;
  r.gear_1.kind = r.gear_2.kind = Mounted::gear;
  r.gear_1.b_r = in.b_1, r.gear_2.b_r = is_set(in.b_2) ? in.b_2 : in.b_1;
  r.gear_1.bore = in.bore_1, r.gear_2.bore = in.bore_2;
}

template <class Tracer>
void load(const Input& in, Result& r, Tracer& trace) {
  const double q = trace.value("q", r.Sigma < 0.0 ? -1.0 : 1.0, "sign of Sigma");
  STEP(k_1, cos(in.alpha_n) * cos(in.beta_1) + q * in.mu * sin(in.beta_1),
       "tangential share of the normal force, gear 1");
  STEP(k_2, cos(in.alpha_n) * cos(in.beta_2) - q * in.mu * sin(in.beta_2),
       "tangential share of the normal force, gear 2");
  if (is_set(in.T_2)) {
    STEP_TO(r, F_n, 2.0 * in.T_2 / (r.d_2 * k_2), "from the torque of gear 2");
  } else if (is_set(in.P)) {
    STEP_TO(r, F_n, 2.0 * in.P / in.n_1 / (r.d_1 * k_1), "from the power of gear 1");
  } else if (is_set(in.T_1)) {
    STEP_TO(r, F_n, 2.0 * in.T_1 / (r.d_1 * k_1), "from the torque of gear 1");
  } else {
    return;
  }
  STEP_TO(r, F_t1, r.F_n * k_1, "against the rotation of gear 1, which drives");
  STEP_TO(r, F_t2, r.F_n * k_2, "in the direction of rotation of gear 2");
  STEP_TO(r, F_a1, r.F_n * (cos(in.alpha_n) * sin(in.beta_1) - q * in.mu * cos(in.beta_1)), "along shaft 1");
  STEP_TO(r, F_a2, r.F_n * (cos(in.alpha_n) * sin(in.beta_2) + q * in.mu * cos(in.beta_2)), "along shaft 2");
  STEP_TO(r, F_r, r.F_n * sin(in.alpha_n), "along the line of centres");
  STEP_TO(r, T_1, F_t1 * r.d_1 / 2.0, "torque of gear 1");
  STEP_TO(r, T_2, F_t2 * r.d_2 / 2.0, "torque of gear 2");
  if (is_set(in.n_1)) {
    STEP_TO(r, P_1, T_1 * in.n_1, "power of gear 1");
    STEP_TO(r, P_2, T_2 * r.n_2, "power of gear 2");
    STEP_TO(r, P_V, P_1 - P_2, "friction in the mesh");
  }
  const double w = trace.value("w", in.turns == Turns::ccw ? 1.0 : -1.0, "1 where gear 1 turns counter-clockwise");
  STEP_TO(r, F_y1, -w * in.K_A * F_t1, "against the rotation of gear 1");
  STEP_TO(r, F_z1, w * in.K_A * F_a1, "a right-hand screw that turns counter-clockwise is pushed towards +z");
  STEP_TO(r, F_y2, -w * in.K_A * F_t2, "gear 2 turns in the opposite direction in its frame");
  STEP_TO(r, F_z2, w * in.K_A * F_a2, "equal and opposite to the force on gear 1 in space");
  hand_over(in, w, r);
}

/// Load value as in Roloff/Matek and Decker, whose allowable values are charts over the sliding velocity.
template <class Tracer>
void rate_wear(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(r.F_n)) return;
  STEP(p_n, pi * in.m_n, "normal pitch");
  STEP(F_t, max(r.F_t1, r.F_t2), "larger tangential force");
  STEP_TO(r, C, in.K_A * F_t / (r.b_e * p_n), "[Roloff-crossed]");
  if (!is_set(in.C_adm)) return;
  STEP_TO(r, u_C, C / in.C_adm, "wear and pitting");
}

}  // namespace crossed

/// Gear 1 can drive gear 2 against the friction along the teeth of gear 2.
bool Crossed::drives(const Input& in) {
  if (!is_set(in.mu) || !is_set(in.beta_1) || !is_set(in.beta_2)) return true;
  const double q = in.beta_1 + in.beta_2 < 0.0 ? -1.0 : 1.0, least = 0.01;
  return std::cos(in.alpha_n) - q * in.mu * std::tan(in.beta_2) > least;
}

bool Crossed::crosses(const Input& in) {
  if (!is_set(in.beta_1) || !is_set(in.beta_2)) return true;
  return std::abs(in.beta_1 + in.beta_2) >= 5.0 * deg.one * (1.0 - 1e-9);
}

template <class Tracer>
Crossed::Result Crossed::evaluate(const Input& in, Tracer& trace) {
  Result r;
  crossed::diameters(in, r, trace);
  crossed::contact(in, r, trace);
  crossed::tips(in, r, trace);
  crossed::slide(in, r, trace);
  crossed::load(in, r, trace);
  crossed::rate_wear(in, r, trace);
  return r;
}

template Crossed::Result Crossed::evaluate(const Input&, NoTrace&);
template Crossed::Result Crossed::evaluate(const Input&, Trace&);

}  // namespace loadpath::gear

template const loadpath::Calculator& loadpath::erased<loadpath::gear::Crossed>();
