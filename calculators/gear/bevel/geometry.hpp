// Cones, diameters and tooth heights of gear.bevel, and the limits of its virtual spur gears.
#pragma once

#include "calculators/gear/bevel/types.hpp"
#include "calculators/gear/tooth_form.hpp"
#include "lib/calculator/trace.hpp"

namespace loadpath::gear::bevel {

using Input = BevelTypes::Input;
using Result = BevelTypes::Result;

template <class Tracer>
void cones(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, i, in.z_2 / in.z_1, "ratio of the teeth");
  STEP_TO(r, delta_1, atan(sin(in.Sigma) / (i + cos(in.Sigma))), "cones with a common apex roll without sliding");
  STEP_TO(r, delta_2, in.Sigma - delta_1, "cone angles add up to the shaft angle");
  STEP_TO(r, d_1, in.m_et * in.z_1, "at the outer end, [KHK-bevel]");
  STEP_TO(r, d_2, in.m_et * in.z_2, "at the outer end, [KHK-bevel]");
  STEP_TO(r, R_e, d_1 / (2.0 * sin(delta_1)), "from the apex to the outer end, [KHK-bevel]");
  STEP_TO(r, R_m, R_e - in.b / 2.0, "to the middle of the face, [Inventor-bevel]");
  STEP_TO(r, d_m1, d_1 * R_m / R_e, "in the middle of the face");
  STEP_TO(r, d_m2, d_2 * R_m / R_e, "in the middle of the face");
  STEP_TO(r, m_m, in.m_et * R_m / R_e, "in the middle of the face");
  STEP_TO(r, x_R, in.b / R_e, "a wider face carries no more: its inner end is weak");
  STEP_TO(r, x_m, in.b / in.m_et, "limit of usual proportions, [AGMA2003]");
}

template <class Tracer>
void heights(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, h_a1, in.m_et * (in.h_aP + in.x_1), "outer addendum, [Inventor-bevel]");
  STEP_TO(r, h_a2, in.m_et * (in.h_aP - in.x_1), "outer addendum, x_2 = -x_1");
  STEP_TO(r, h_f1, in.m_et * (in.h_fP - in.x_1), "outer dedendum");
  STEP_TO(r, h_f2, in.m_et * (in.h_fP + in.x_1), "outer dedendum");
  STEP_TO(r, d_a1, r.d_1 + 2.0 * h_a1 * cos(r.delta_1), "across the pitch cone, [KHK-bevel]");
  STEP_TO(r, d_a2, r.d_2 + 2.0 * h_a2 * cos(r.delta_2), "across the pitch cone, [KHK-bevel]");
  STEP_TO(r, d_f1, r.d_1 - 2.0 * h_f1 * cos(r.delta_1), "across the pitch cone");
  STEP_TO(r, d_f2, r.d_2 - 2.0 * h_f2 * cos(r.delta_2), "across the pitch cone");
  STEP_TO(r, d_fi1, d_f1 * (r.R_e - in.b) / r.R_e, "the root cone has its tip in the apex");
  STEP_TO(r, d_fi2, d_f2 * (r.R_e - in.b) / r.R_e, "the root cone has its tip in the apex");
  STEP_TO(r, theta_f1, atan(h_f1 / r.R_e), "root cone with its tip in the apex, [KHK-bevel]");
  STEP_TO(r, theta_f2, atan(h_f2 / r.R_e), "root cone with its tip in the apex, [KHK-bevel]");
  STEP_TO(r, delta_a1, r.delta_1 + theta_f2, "parallel to the root cone of the mate, [KHK-bevel]");
  STEP_TO(r, delta_a2, r.delta_2 + theta_f1, "parallel to the root cone of the mate, [KHK-bevel]");
  STEP_TO(r, delta_f1, r.delta_1 - theta_f1, "[KHK-bevel]");
  STEP_TO(r, delta_f2, r.delta_2 - theta_f2, "[KHK-bevel]");
}

/// Rims between bore and root circle at the inner end, where they are thinnest, over the tooth depth there.
template <class Tracer>
void rims(const Input& in, Result& r, Tracer& trace) {
  STEP(inner, (r.R_e - in.b) / r.R_e, "size of the inner end over that of the outer one");
  if (is_set(in.bore_1)) {
    STEP_TO(r, m_R1, (r.d_fi1 - in.bore_1) / (2.0 * inner * (r.h_a1 + r.h_f1)),
            "rim over tooth depth, as in gear.pair");
  }
  if (is_set(in.bore_2)) {
    STEP_TO(r, m_R2, (r.d_fi2 - in.bore_2) / (2.0 * inner * (r.h_a2 + r.h_f2)),
            "rim over tooth depth, as in gear.pair");
  }
}

/// Tip thickness over module of a spur gear with z_v teeth.
inline double tip_thickness(const Input& in, double z_v, double x) {
  const double tip = z_v + 2.0 * (in.h_aP + x);
  return tip * half_angle(in.alpha, z_v, x, 0.5 * tip);
}

/// The spur gears on the back cones, in modules, by Tredgold.
template <class Tracer>
void virtual_gears(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, z_v1, in.z_1 / cos(r.delta_1), "spur gear on the back cone, [Inventor-bevel]");
  STEP_TO(r, z_v2, in.z_2 / cos(r.delta_2), "spur gear on the back cone, [Inventor-bevel]");
  STEP(r_a1, z_v1 / 2.0 + in.h_aP + in.x_1, "tip radius of the virtual gear 1 in modules");
  STEP(r_a2, z_v2 / 2.0 + in.h_aP - in.x_1, "tip radius of the virtual gear 2 in modules");
  STEP(g_1, sqrt(pow<2>(r_a1) - pow<2>(z_v1 / 2.0 * cos(in.alpha))), "from the base circle to the tip, gear 1");
  STEP(g_2, sqrt(pow<2>(r_a2) - pow<2>(z_v2 / 2.0 * cos(in.alpha))), "from the base circle to the tip, gear 2");
  STEP_TO(r, eps_v, (g_1 + g_2 - (z_v1 + z_v2) / 2.0 * sin(in.alpha)) / (pi * cos(in.alpha)),
          "length of contact over the base pitch, [Inventor-bevel]");
  STEP(x_free1, z_v1 * pow<2>(sin(in.alpha)) / 2.0 - in.h_aP + in.x_1, "margin to undercut, gear 1");
  STEP(x_free2, z_v2 * pow<2>(sin(in.alpha)) / 2.0 - in.h_aP - in.x_1, "margin to undercut, gear 2");
  STEP_TO(r, x_free, min(x_free1, x_free2), "the smaller one");
  const double s_a1 = trace.value("s_a1", tip_thickness(in, z_v1, in.x_1), "tip of the virtual gear 1");
  const double s_a2 = trace.value("s_a2", tip_thickness(in, z_v2, -in.x_1), "tip of the virtual gear 2");
  STEP_TO(r, s_a, min(s_a1, s_a2), "the smaller one");
}

}  // namespace loadpath::gear::bevel
