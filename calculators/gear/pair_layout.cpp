// Reference circles, centre distance or profile shift, diameters and clearances of a pair of gears.
#include "calculators/gear/involute.hpp"
#include "calculators/gear/pair_parts.hpp"

namespace loadpath::gear {

namespace {

template <class Tracer>
void reference_circles(const Pair::Input& in, PairResult& r, Tracer& trace) {
  const auto m_n = in.m_n;
  const double alpha_n = in.alpha_n, beta = in.beta, z_1 = in.z_1, z_2 = in.z_2;
  STEP(alpha_t, atan(tan(alpha_n) / cos(beta)), "transverse pressure angle, [ISO21771]");
  STEP(m_t, m_n / cos(beta), "transverse module");
  STEP(d_1, m_t * z_1, "reference circle");
  STEP(d_b1, d_1 * cos(alpha_t), "base circle");
  r.alpha_t = alpha_t, r.m_t = m_t, r.d_1 = d_1, r.d_b1 = d_b1;
  if (in.mesh == Mesh::rack) return;
  STEP(d_2, m_t * z_2, "reference circle");
  STEP(d_b2, d_2 * cos(alpha_t), "base circle");
  STEP(u, z_2 / z_1, "gear ratio");
  r.d_2 = d_2, r.d_b2 = d_b2, r.u = u;
}

/// The profile shift follows from the centre distance.
template <class Tracer>
void shift_from_distance(const Pair::Input& in, double g, PairResult& r, Tracer& trace) {
  const auto a = r.a, a_w = in.a_w;
  const double alpha_n = in.alpha_n, alpha_t = r.alpha_t, z_1 = in.z_1, z_2 = in.z_2, x_1 = in.x_1;
  STEP(inv_t, tan(alpha_t) - alpha_t, "involute function of the pressure angle");
  STEP(alpha_wt, acos(a * cos(alpha_t) / a_w), "working pressure angle at the centre distance, [ISO21771]");
  STEP(inv_wt, tan(alpha_wt) - alpha_wt, "its involute function");
  STEP(x_0, g * (z_2 + g * z_1) * (inv_wt - inv_t) / (2.0 * tan(alpha_n)),
       "sum of the profile shifts that meshes without backlash, [ISO21771]");
  r.a_w = a_w, r.alpha_wt = alpha_wt, r.x_0 = x_0, r.x_2 = in.x_2;
  if (is_set(in.x_2)) return;
  STEP(x_2, x_0 - x_1, "what gear 2 has of it");
  r.x_2 = x_2;
}

/// The centre distance follows from the profile shifts.
template <class Tracer>
void distance_from_shift(const Pair::Input& in, double g, PairResult& r, Tracer& trace) {
  const auto a = r.a;
  const double alpha_n = in.alpha_n, alpha_t = r.alpha_t, z_1 = in.z_1, z_2 = in.z_2, x_1 = in.x_1;
  const double x_2 = r.x_2 = is_set(in.x_2) ? in.x_2 : 0.0;
  trace.value("x_2", x_2, is_set(in.x_2) ? "as given" : "none, as neither it nor a centre distance is given");
  STEP(inv_t, tan(alpha_t) - alpha_t, "involute function of the pressure angle");
  STEP(x_0, x_1 + x_2, "sum of the profile shifts");
  STEP(inv_wt, inv_t + 2.0 * x_0 * tan(alpha_n) / (g * (z_2 + g * z_1)),
       "involute function of the working pressure angle, no backlash, [ISO21771]");
  const double alpha_wt = angle_of_involute(inv_wt);
  trace.angle("alpha_wt", alpha_wt, "the angle with this involute function");
  STEP(a_w, a * cos(alpha_t) / cos(alpha_wt), "working centre distance, [ISO21771]");
  r.a_w = a_w, r.alpha_wt = alpha_wt, r.x_0 = x_0;
}

template <class Tracer>
void diameters(const Pair::Input& in, double g, PairResult& r, Tracer& trace) {
  const auto m_n = in.m_n;
  const auto a = r.a, a_w = r.a_w, d_1 = r.d_1, d_2 = r.d_2;
  const double z_1 = in.z_1, z_2 = in.z_2, x_1 = in.x_1, x_2 = r.x_2, h_aP = in.h_aP, h_fP = in.h_fP;
  STEP(d_w1, 2.0 * a_w * z_1 / (z_2 + g * z_1), "working pitch circle");
  STEP(d_w2, 2.0 * a_w * z_2 / (z_2 + g * z_1), "working pitch circle");
  if (in.shortening == Shortening::none) {
    trace.value("k", 0.0, "full addendum");
    r.k = 0.0;
  } else {
    STEP(k, max(0.0, x_1 + x_2 - g * (a_w - a) / m_n), "shortens both tips where the clearance would else be less");
    r.k = k;
  }
  const double k = r.k;
  STEP(d_a1, d_1 + 2.0 * m_n * (h_aP + x_1 - k), "tip circle");
  STEP(d_a2, d_2 + 2.0 * g * m_n * (h_aP + x_2 - k), "tip circle");
  STEP(d_f1, d_1 - 2.0 * m_n * (h_fP - x_1), "root circle");
  STEP(d_f2, d_2 - 2.0 * g * m_n * (h_fP - x_2), "root circle");
  STEP(c_1, g * (a_w - d_f2 / 2.0) - d_a1 / 2.0, "from the tip of gear 1 to the root of gear 2");
  STEP(c_2, g * (a_w - d_a2 / 2.0) - d_f1 / 2.0, "from the tip of gear 2 to the root of gear 1");
  r.d_w1 = d_w1, r.d_w2 = d_w2, r.d_a1 = d_a1, r.d_a2 = d_a2, r.d_f1 = d_f1, r.d_f2 = d_f2, r.c_1 = c_1, r.c_2 = c_2;
}

/// Against a rack the pitch circle is the reference circle wherever the rack stands.
template <class Tracer>
void lay_out_rack(const Pair::Input& in, PairResult& r, Tracer& trace) {
  const auto m_n = in.m_n;
  const auto d_1 = r.d_1;
  const double alpha_t = r.alpha_t, x_1 = in.x_1, h_aP = in.h_aP, h_fP = in.h_fP;
  r.a = 0.5 * d_1, r.a_w = in.a_w, r.k = 0.0;
  if (!is_set(in.a_w)) {
    STEP(a_w, d_1 / 2.0 + x_1 * m_n, "from the axis to the reference line of the rack, no backlash");
    r.a_w = a_w, r.x_0 = x_1;
  } else {
    const auto a_w = r.a_w;
    STEP(x_0, (a_w - d_1 / 2.0) / m_n, "profile shift that meshes without backlash");
    r.x_0 = x_0;
  }
  const auto a_w = r.a_w;
  STEP(alpha_wt, alpha_t, "the rack's own angle");
  STEP(d_w1, d_1, "the pitch circle is the reference circle");
  STEP(d_a1, d_1 + 2.0 * m_n * (h_aP + x_1), "tip circle");
  STEP(d_f1, d_1 - 2.0 * m_n * (h_fP - x_1), "root circle");
  STEP(c_1, a_w + h_fP * m_n - d_a1 / 2.0, "from the tip of gear 1 to the root of the rack");
  STEP(c_2, a_w - h_aP * m_n - d_f1 / 2.0, "from the tip of the rack to the root of gear 1");
  r.alpha_wt = alpha_wt, r.d_w1 = d_w1, r.d_a1 = d_a1, r.d_f1 = d_f1, r.c_1 = c_1, r.c_2 = c_2;
}

}  // namespace

template <class Tracer>
void lay_out(const Pair::Input& in, PairResult& r, Tracer& trace) {
  reference_circles(in, r, trace);
  if (in.mesh == Mesh::rack) return lay_out_rack(in, r, trace);
  const double g = sign_of(in.mesh), z_1 = in.z_1, z_2 = in.z_2;
  const auto m_t = r.m_t;
  trace.value("g", g, "1 with a wheel, -1 with a ring, whose teeth [ISO21771] counts negative");
  STEP(a, m_t * (z_2 + g * z_1) / 2.0, "reference centre distance");
  r.a = a;
  if (is_set(in.a_w)) {
    shift_from_distance(in, g, r, trace);
  } else {
    distance_from_shift(in, g, r, trace);
  }
  diameters(in, g, r, trace);
}

template void lay_out(const Pair::Input&, PairResult&, NoTrace&);
template void lay_out(const Pair::Input&, PairResult&, Trace&);

}  // namespace loadpath::gear
