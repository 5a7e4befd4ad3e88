// Reference circles, centre distance or profile shift, diameters and clearances of a pair of gears.
#pragma once

#include "calculators/gear/involute.hpp"
#include "calculators/gear/pair_parts.hpp"

namespace loadpath::gear {

namespace layout {

template <class Tracer>
void reference_circles(const PairInput& in, PairResult& r, Tracer& trace) {
  STEP_TO(r, alpha_t, atan(tan(in.alpha_n) / cos(in.beta)), "transverse pressure angle, [ISO21771]");
  STEP_TO(r, m_t, in.m_n / cos(in.beta), "transverse module");
  STEP_TO(r, d_1, m_t * in.z_1, "reference circle");
  STEP_TO(r, d_b1, d_1 * cos(alpha_t), "base circle");
  if (in.mesh == Mesh::rack) return;
  STEP_TO(r, d_2, m_t * in.z_2, "reference circle");
  STEP_TO(r, d_b2, d_2 * cos(alpha_t), "base circle");
  STEP_TO(r, u, in.z_2 / in.z_1, "gear ratio");
}

/// The profile shift follows from the centre distance.
template <class Tracer>
void shift_from_distance(const PairInput& in, double g, PairResult& r, Tracer& trace) {
  STEP(inv_t, tan(r.alpha_t) - r.alpha_t, "involute function of the pressure angle");
  STEP_TO(r, alpha_wt, acos(r.a * cos(r.alpha_t) / in.a_w),
          "working pressure angle at the centre distance, [ISO21771]");
  STEP(inv_wt, tan(alpha_wt) - alpha_wt, "its involute function");
  STEP_TO(r, x_0, g * (in.z_2 + g * in.z_1) * (inv_wt - inv_t) / (2.0 * tan(in.alpha_n)),
          "sum of the profile shifts for zero backlash, [ISO21771]");
  r.a_w = in.a_w, r.x_2 = in.x_2;
  if (is_set(in.x_2)) return;
  STEP_TO(r, x_2, x_0 - in.x_1, "profile shift coefficient, gear 2");
}

/// The centre distance follows from the profile shifts.
template <class Tracer>
void distance_from_shift(const PairInput& in, double g, PairResult& r, Tracer& trace) {
  const double x_2 = r.x_2 = is_set(in.x_2) ? in.x_2 : 0.0;
  trace.value("x_2", x_2, is_set(in.x_2) ? "as given" : "none, as neither it nor a centre distance is given");
  STEP(inv_t, tan(r.alpha_t) - r.alpha_t, "involute function of the pressure angle");
  STEP_TO(r, x_0, in.x_1 + x_2, "sum of the profile shifts");
  STEP(inv_wt, inv_t + 2.0 * x_0 * tan(in.alpha_n) / (g * (in.z_2 + g * in.z_1)),
       "involute function of the working pressure angle, no backlash, [ISO21771]");
  const double alpha_wt = r.alpha_wt =
      trace.angle("alpha_wt", angle_of_involute(inv_wt), "the angle with this involute function");
  STEP_TO(r, a_w, r.a * cos(r.alpha_t) / cos(alpha_wt), "working centre distance, [ISO21771]");
}

template <class Tracer>
void diameters(const PairInput& in, double g, PairResult& r, Tracer& trace) {
  STEP_TO(r, d_w1, 2.0 * r.a_w * in.z_1 / (in.z_2 + g * in.z_1), "working pitch circle");
  STEP_TO(r, d_w2, 2.0 * r.a_w * in.z_2 / (in.z_2 + g * in.z_1), "working pitch circle");
  if (in.shortening == Shortening::none) {
    r.k = trace.value("k", 0.0, "full addendum");
  } else {
    STEP_TO(r, k, max(0.0, in.x_1 + r.x_2 - g * (r.a_w - r.a) / in.m_n), "tip shortening that keeps the clearance");
  }
  STEP_TO(r, d_a1, r.d_1 + 2.0 * in.m_n * (in.h_aP + in.x_1 - r.k), "tip circle");
  if (is_set(in.d_a2)) {
    r.d_a2 = trace.value("d_a2", in.d_a2, "tip circle as given");
  } else {
    STEP_TO(r, d_a2, r.d_2 + 2.0 * g * in.m_n * (in.h_aP + r.x_2 - r.k), "tip circle");
  }
  STEP_TO(r, d_f1, r.d_1 - 2.0 * in.m_n * (in.h_fP - in.x_1), "root circle");
  STEP_TO(r, d_f2, r.d_2 - 2.0 * g * in.m_n * (in.h_fP - r.x_2), "root circle");
  STEP_TO(r, c_1, g * (r.a_w - d_f2 / 2.0) - d_a1 / 2.0, "from the tip of gear 1 to the root of gear 2");
  STEP_TO(r, c_2, g * (r.a_w - r.d_a2 / 2.0) - d_f1 / 2.0, "from the tip of gear 2 to the root of gear 1");
}

/// With a rack the pitch circle is the reference circle at any rack position.
template <class Tracer>
void lay_out_rack(const PairInput& in, PairResult& r, Tracer& trace) {
  r.a = 0.5 * r.d_1, r.a_w = in.a_w, r.k = 0.0;
  if (!is_set(in.a_w)) {
    STEP_TO(r, a_w, r.d_1 / 2.0 + in.x_1 * in.m_n, "from the axis to the reference line of the rack, no backlash");
    r.x_0 = in.x_1;
  } else {
    STEP_TO(r, x_0, (r.a_w - r.d_1 / 2.0) / in.m_n, "profile shift that meshes without backlash");
  }
  STEP_TO(r, alpha_wt, r.alpha_t, "the rack's own angle");
  STEP_TO(r, d_w1, r.d_1, "the pitch circle is the reference circle");
  STEP_TO(r, d_a1, r.d_1 + 2.0 * in.m_n * (in.h_aP + in.x_1), "tip circle");
  STEP_TO(r, d_f1, r.d_1 - 2.0 * in.m_n * (in.h_fP - in.x_1), "root circle");
  STEP_TO(r, c_1, r.a_w + in.h_fP * in.m_n - d_a1 / 2.0, "from the tip of gear 1 to the root of the rack");
  STEP_TO(r, c_2, r.a_w - in.h_aP * in.m_n - d_f1 / 2.0, "from the tip of the rack to the root of gear 1");
}

}  // namespace layout

/// Reference circles, centre distance or profile shift, diameters and clearances.
template <class Tracer>
void lay_out(const PairInput& in, PairResult& r, Tracer& trace) {
  using namespace layout;
  reference_circles(in, r, trace);
  if (in.mesh == Mesh::rack) return lay_out_rack(in, r, trace);
  const double g = sign_of(in.mesh);
  trace.value("g", g, "1 for an external gear, -1 for a ring gear, with negative teeth in [ISO21771]");
  STEP_TO(r, a, r.m_t * (in.z_2 + g * in.z_1) / 2.0, "reference centre distance");
  if (is_set(in.a_w)) {
    shift_from_distance(in, g, r, trace);
  } else {
    distance_from_shift(in, g, r, trace);
  }
  diameters(in, g, r, trace);
}

}  // namespace loadpath::gear
