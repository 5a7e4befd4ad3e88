#include "calculators/gear/bevel/bevel.hpp"

#include "calculators/gear/bevel/geometry.hpp"
#include "calculators/gear/bevel/rating.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

#include <cmath>

namespace loadpath::gear {

namespace bevel {

/// Loads on the shafts, with K_A, each in its own frame. The root circle under a hub is that of the inner end. `w`: 1
/// where gear 1 turns counter-clockwise, else -1.
inline void hand_over(const Input& in, Moment T_1, double w, Result& r) {
  const double K_A = in.K_A, inner = (r.R_e - in.b) / r.R_e;
  r.gear_1 = shaft_load(K_A * T_1, {-K_A * r.F_r1, r.F_y1, K_A * r.F_a1}, r.d_m1, w * in.n_1);
  r.gear_2 = shaft_load(K_A * r.T_2, {-K_A * r.F_r2, r.F_y1, K_A * r.F_a2}, r.d_m2, -w * r.n_2);
  r.gear_1.d_f = r.d_fi1, r.gear_1.h_t = inner * (r.h_a1 + r.h_f1);
  r.gear_2.d_f = r.d_fi2, r.gear_2.h_t = inner * (r.h_a2 + r.h_f2);
  r.gear_1.kind = r.gear_2.kind = Mounted::gear;
  r.gear_1.b_r = r.gear_2.b_r = in.b;
  r.gear_1.bore = in.bore_1, r.gear_2.bore = in.bore_2;
}

template <class Tracer>
void load(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.n_1)) {
    STEP_TO(r, n_2, in.n_1 / r.i, "ratio of the teeth");
    STEP_TO(r, v_e, in.n_1 * r.d_1 / 2.0, "at the outer pitch diameter");
  }
  Moment torque = in.T_1;
  if (is_set(in.P)) torque = NAMED_STEP("T_1", in.P / in.n_1, "torque from the power, nominal");
  if (!is_set(torque)) return;
  const Moment T = trace.value("T", torque, "torque of gear 1");
  STEP_TO(r, T_2, abs(T) * r.i, "without losses");
  STEP_TO(r, F_t, 2.0 * abs(T) / r.d_m1, "at the mean pitch diameter");
  STEP_TO(r, F_r1, F_t * tan(in.alpha) * cos(r.delta_1), "the separating force, across shaft 1");
  STEP_TO(r, F_a1, F_t * tan(in.alpha) * sin(r.delta_1), "the separating force, along shaft 1");
  STEP_TO(r, F_r2, F_t * tan(in.alpha) * cos(r.delta_2), "the separating force, across shaft 2");
  STEP_TO(r, F_a2, F_t * tan(in.alpha) * sin(r.delta_2), "the separating force, along shaft 2");
  STEP_TO(r, W_t, 2.0 * abs(T) / r.d_1, "at the outer pitch diameter, [AGMA2003]");
  const double w = trace.value("w", in.turns == Turns::ccw ? 1.0 : -1.0, "1 where gear 1 turns counter-clockwise");
  STEP_TO(r, F_y1, -w * in.K_A * 2.0 * T / r.d_m1, "against the rotation where gear 1 drives");
  hand_over(in, T, w, r);
}

}  // namespace bevel

/// Both pitch cone angles below 90 deg: beyond, the teeth of one gear point inwards.
bool Bevel::cones_meet(const Input& in) {
  if (!(in.z_1 > 0) || !(in.z_2 > 0)) return true;
  const double u = in.z_2 / in.z_1, turn = std::cos(in.Sigma), least = 1e-6;
  return u + turn > least && 1.0 / u + turn > least;
}

/// The outer cone distance.
static Length cone_distance(const Bevel::Input& in) {
  NoTrace quiet;
  Bevel::Result r;
  bevel::cones(in, r, quiet);
  return r.R_e;
}

bool Bevel::face_fits(const Input& in) {
  if (!cones_meet(in) || !is_set(in.b) || !is_set(in.m_et) || !(in.z_1 > 0) || !(in.z_2 > 0)) return true;
  return in.b < 0.5 * cone_distance(in);
}

FieldFault Bevel::wide_face(const Input& in) {
  const Length R_e = cone_distance(in);
  return {"b",
          say("the face width b = {1} must be less than half the outer cone distance R_e = {2}",
              format_quantity(in_si(in.b), "mm", 4), format_quantity(in_si(R_e), "mm", 4)),
          say("at most R_e/3 passes: {1}", format_quantity(in_si(R_e) / 3.0, "mm", 4))};
}

template <class Tracer>
Bevel::Result Bevel::evaluate(const Input& in, Tracer& trace) {
  Result r;
  bevel::cones(in, r, trace);
  bevel::heights(in, r, trace);
  bevel::rims(in, r, trace);
  bevel::virtual_gears(in, r, trace);
  bevel::load(in, r, trace);
  if (!rates(in)) return r;
  bevel::load_factors(in, r, trace);
  bevel::strength_factors(in, r, trace);
  bevel::rate_pitting(in, r, trace);
  bevel::rate_bending(in, r, trace);
  return r;
}

template Bevel::Result Bevel::evaluate(const Input&, NoTrace&);
template Bevel::Result Bevel::evaluate(const Input&, Trace&);

}  // namespace loadpath::gear

template const loadpath::Calculator& loadpath::erased<loadpath::gear::Bevel>();
