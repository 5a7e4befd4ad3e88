#include "calculators/gear/worm/worm.hpp"

#include "calculators/gear/worm/strength.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::gear {

namespace worm_gear {

template <class Tracer>
void lay_out(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, i, in.z_2 / in.z_1, "ratio of the speeds");
  STEP_TO(r, q, in.d_1 / in.m_x, "[KHK-worm]");
  STEP_TO(r, gamma, atan(in.m_x * in.z_1 / in.d_1), "[KHK-worm]");
  STEP_TO(r, p_x, pi * in.m_x, "from thread to thread");
  STEP_TO(r, p_z, p_x * in.z_1, "advance of a thread in a revolution");
  STEP_TO(r, d_2, in.m_x * in.z_2, "[KHK-worm]");
  STEP_TO(r, a, (in.d_1 + d_2) / 2.0, "without profile shift");
  STEP_TO(r, d_a1, in.d_1 + 2.0 * in.h_aP * in.m_x, "[KHK-worm]");
  STEP_TO(r, d_f1, in.d_1 - 2.0 * in.h_fP * in.m_x, "[KHK-worm]");
  STEP_TO(r, d_a2, d_2 + 2.0 * in.h_aP * in.m_x, "in the middle plane, [KHK-worm]");
  STEP_TO(r, d_f2, d_2 - 2.0 * in.h_fP * in.m_x, "in the middle plane");
  if (is_set(in.bore_2)) {
    STEP_TO(r, m_R2, (d_f2 - in.bore_2) / (d_a2 - d_f2), "rim over tooth depth, as in gear.pair");
  }
  STEP_TO(r, L_1, p_x * (4.5 + 0.02 * in.z_2), "[KHK-worm]");
  STEP_TO(r, b_2H, 2.0 * in.m_x * sqrt(q + 1.0), "[KHK-worm]");
  STEP_TO(r, x_b, in.b_2 / in.m_x, "narrower wheels are not customary, from memory");
  STEP(alpha_x, atan(tan(in.alpha_n) / cos(gamma)), "axial pressure angle");
  STEP_TO(r, z_min, 2.0 * in.h_aP / pow<2>(sin(alpha_x)), "a rack in the middle plane cuts the wheel");
  STEP_TO(r, x_z, in.z_2 / z_min, "undercut condition");
  STEP_TO(r, F_e, min(in.b_2, 0.67 * in.d_1), "a wider face is not included");
}

template <class Tracer>
void slide(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.n_1)) {
    STEP_TO(r, n_2, in.n_1 / r.i, "speed of the wheel");
    STEP_TO(r, v_2, n_2 * r.d_2 / 2.0, "at the reference diameter");
    STEP_TO(r, v_s, in.n_1 * in.d_1 / (2.0 * cos(r.gamma)), "along the thread");
  }
  r.mu = friction(in, r, trace);
  STEP_TO(r, eta, (cos(in.alpha_n) - r.mu * tan(r.gamma)) / (cos(in.alpha_n) + r.mu / tan(r.gamma)),
          "the worm drives, [AGMA6034]");
  STEP_TO(r, eta_b, (cos(in.alpha_n) - r.mu / tan(r.gamma)) / (cos(in.alpha_n) + r.mu * tan(r.gamma)),
          "the wheel drives: friction is reversed, [Inventor]");
  if (in.locking != WormTypes::Locking::required) return;
  STEP_TO(r, x_L, tan(r.gamma) * cos(in.alpha_n) / r.mu, "the wheel does not turn the worm");
}

/// Loads on the shafts, with K_A. `h`: 1 for a right-hand worm, else -1; `w`: 1 where it turns counter-clockwise.
inline void hand_over(const Input& in, double h, double w, Result& r) {
  const double K_A = in.K_A;
  r.worm = shaft_load(K_A * r.T_1, {-K_A * r.F_r, r.F_y1, r.F_z1}, in.d_1, w * in.n_1);
  r.wheel = shaft_load(K_A * r.T_2, {-K_A * r.F_r, -r.F_z1, -r.F_y1}, r.d_2, -w * h * r.n_2);
  r.worm.d_f = r.d_f1, r.worm.h_t = (r.d_a1 - r.d_f1) / 2.0;
  r.wheel.d_f = r.d_f2, r.wheel.h_t = (r.d_a2 - r.d_f2) / 2.0;
  r.worm.kind = r.wheel.kind = Mounted::gear;
  r.wheel.b_r = in.b_2, r.wheel.bore = in.bore_2;
}

template <class Tracer>
void load(const Input& in, Result& r, Tracer& trace) {
  STEP(k_1, cos(in.alpha_n) * sin(r.gamma) + r.mu * cos(r.gamma), "share of the normal force along the wheel shaft");
  STEP(k_2, cos(in.alpha_n) * cos(r.gamma) - r.mu * sin(r.gamma), "share of the normal force along the worm");
  if (is_set(in.T_2)) {
    STEP_TO(r, F_n, 2.0 * in.T_2 / (r.d_2 * k_2), "from the torque of the wheel, [AGMA6034]");
  } else if (is_set(in.P)) {
    STEP_TO(r, F_n, 2.0 * in.P / in.n_1 / (in.d_1 * k_1), "from the power of the worm, [AGMA6034]");
  } else if (is_set(in.T_1)) {
    STEP_TO(r, F_n, 2.0 * in.T_1 / (in.d_1 * k_1), "from the torque of the worm, [AGMA6034]");
  } else {
    return;
  }
  STEP_TO(r, F_t1, r.F_n * k_1, "tangential on the worm, axial on the wheel");
  STEP_TO(r, F_t2, r.F_n * k_2, "tangential on the wheel, axial on the worm");
  STEP_TO(r, F_r, r.F_n * sin(in.alpha_n), "along the line of centres");
  STEP_TO(r, T_1, F_t1 * in.d_1 / 2.0, "torque of the worm");
  STEP_TO(r, T_2, F_t2 * r.d_2 / 2.0, "torque of the wheel");
  STEP_TO(r, tau_f1, 16.0 * in.K_A * T_1 / (pi * pow<3>(r.d_f1)),
          "solid core; 100 MPa is high for worms of steel, from memory");
  if (is_set(in.n_1)) {
    STEP_TO(r, P_1, T_1 * in.n_1, "power of the worm");
    STEP_TO(r, P_2, T_2 * r.n_2, "power of the wheel");
    STEP_TO(r, P_V, P_1 - P_2, "friction in the mesh");
  }
  const double h = trace.value("h", in.hand == Hand::right ? 1.0 : -1.0, "1 for a right-hand worm");
  const double w = trace.value("w", in.turns == Turns::ccw ? 1.0 : -1.0, "1 where the worm turns counter-clockwise");
  STEP_TO(r, F_y1, -w * in.K_A * F_t1, "against the rotation of the worm");
  STEP_TO(r, F_z1, w * h * in.K_A * F_t2, "a right-hand screw that turns counter-clockwise is pushed towards +z");
  hand_over(in, h, w, r);
}

}  // namespace worm_gear

template <class Tracer>
Worm::Result Worm::evaluate(const Input& in, Tracer& trace) {
  Result r;
  worm_gear::lay_out(in, r, trace);
  worm_gear::slide(in, r, trace);
  worm_gear::load(in, r, trace);
  worm_gear::rate_wear(in, r, trace);
  worm_gear::bend(in, r, trace);
  worm_gear::balance_heat(in, r, trace);
  return r;
}

template Worm::Result Worm::evaluate(const Input&, NoTrace&);
template Worm::Result Worm::evaluate(const Input&, Trace&);

}  // namespace loadpath::gear

template const loadpath::Calculator& loadpath::erased<loadpath::gear::Worm>();
