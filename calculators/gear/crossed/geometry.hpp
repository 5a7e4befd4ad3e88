// Diameters, path of contact and tooth form of gear.crossed.
//
// The line of action is at the angle beta_b to the plane of rotation of each gear. A path of length g along it is thus
// g cos(beta_b) in that plane, and moves the contact point by g sin(beta_b) along the face.
#pragma once

#include "calculators/gear/crossed/types.hpp"
#include "calculators/gear/involute.hpp"
#include "lib/calculator/trace.hpp"

#include <cmath>

namespace loadpath::gear::crossed {

using Input = CrossedTypes::Input;
using Result = CrossedTypes::Result;

template <class Tracer>
void diameters(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, i, in.z_2 / in.z_1, "ratio of the teeth, [SDP-SI-crossed] (7-3)");
  STEP_TO(r, Sigma, in.beta_1 + in.beta_2, "teeth are parallel at the pitch point, [SDP-SI-crossed] (7-1)");
  STEP_TO(r, d_1, in.m_n * in.z_1 / cos(in.beta_1), "[SDP-SI-crossed] (6-7)");
  STEP_TO(r, d_2, in.m_n * in.z_2 / cos(in.beta_2), "[SDP-SI-crossed] (6-7)");
  STEP_TO(r, a, (d_1 + d_2) / 2.0, "x_2 = -x_1, [SDP-SI-crossed] (7-2)");
  STEP_TO(r, d_a1, d_1 + 2.0 * in.m_n * (in.h_aP + in.x_1), "addendum of the basic rack, shifted");
  STEP_TO(r, d_a2, d_2 + 2.0 * in.m_n * (in.h_aP - in.x_1), "addendum of the basic rack, shifted");
  STEP_TO(r, d_f1, d_1 - 2.0 * in.m_n * (in.h_fP - in.x_1), "dedendum of the basic rack, shifted");
  STEP_TO(r, d_f2, d_2 - 2.0 * in.m_n * (in.h_fP + in.x_1), "dedendum of the basic rack, shifted");
  if (is_set(in.bore_1)) {
    STEP_TO(r, m_R1, (d_f1 - in.bore_1) / (d_a1 - d_f1), "rim over tooth depth, as in gear.pair");
  }
  if (is_set(in.bore_2)) {
    STEP_TO(r, m_R2, (d_f2 - in.bore_2) / (d_a2 - d_f2), "rim over tooth depth, as in gear.pair");
  }
}

/// Length of contact of two involute helicoids, which touch in a point.
template <class Tracer>
void contact(const Input& in, Result& r, Tracer& trace) {
  STEP(alpha_t1, atan(tan(in.alpha_n) / cos(in.beta_1)), "transverse pressure angle, gear 1");
  STEP(alpha_t2, atan(tan(in.alpha_n) / cos(in.beta_2)), "transverse pressure angle, gear 2");
  STEP_TO(r, d_b1, r.d_1 * cos(alpha_t1), "base circle");
  STEP_TO(r, d_b2, r.d_2 * cos(alpha_t2), "base circle");
  STEP_TO(r, beta_b1, atan(tan(in.beta_1) * cos(alpha_t1)), "helix on the base cylinder");
  STEP_TO(r, beta_b2, atan(tan(in.beta_2) * cos(alpha_t2)), "helix on the base cylinder");
  STEP(g_t1, (sqrt(pow<2>(r.d_a1) - pow<2>(d_b1)) - r.d_1 * sin(alpha_t1)) / 2.0, "in the transverse plane, gear 1");
  STEP(g_t2, (sqrt(pow<2>(r.d_a2) - pow<2>(d_b2)) - r.d_2 * sin(alpha_t2)) / 2.0, "in the transverse plane, gear 2");
  STEP_TO(r, g_a1, g_t1 / cos(beta_b1), "along the line of action");
  STEP_TO(r, g_a2, g_t2 / cos(beta_b2), "along the line of action");
  STEP(p_bn, pi * in.m_n * cos(in.alpha_n), "normal base pitch, the same of both gears");
  STEP_TO(r, eps_n, (g_a1 + g_a2) / p_bn, "point contact: without overlap ratio");
  STEP(g_max, max(g_a1, g_a2), "longer part of the path of contact");
  const Length b_w2 = is_set(in.b_2) ? trace.value("b_w2", in.b_2, "face width of gear 2, as given")
                                     : trace.value("b_w2", in.b_1, "face width of gear 2, that of gear 1");
  STEP_TO(r, b_e, min(min(in.b_1, b_w2), 10.0 * in.m_n), "a wider face is not in contact, [Roloff-crossed]");
  STEP_TO(r, x_b1, 2.0 * g_max * abs(sin(beta_b1)) / in.b_1, "pitch point in the middle of the face");
  STEP_TO(r, x_b2, 2.0 * g_max * abs(sin(beta_b2)) / b_w2, "pitch point in the middle of the face");
  STEP(x_free1, in.z_1 * pow<2>(sin(alpha_t1)) / (2.0 * cos(in.beta_1)) - in.h_aP + in.x_1,
       "margin to undercut, gear 1");
  STEP(x_free2, in.z_2 * pow<2>(sin(alpha_t2)) / (2.0 * cos(in.beta_2)) - in.h_aP - in.x_1,
       "margin to undercut, gear 2");
  STEP_TO(r, x_free, min(x_free1, x_free2), "the smaller one");
}

/// Normal tooth thickness at the tip, over the module: by the involute in the transverse plane.
inline double tip_thickness(const Input& in, double z, double beta, double x) {
  const double alpha_t = std::atan(std::tan(in.alpha_n) / std::cos(beta));
  const double d = z / std::cos(beta), d_a = d + 2.0 * (in.h_aP + x);
  const double alpha_at = std::acos(d * std::cos(alpha_t) / d_a);
  const double half = (pi / 2.0 + 2.0 * x * std::tan(in.alpha_n)) / z + involute(alpha_t) - involute(alpha_at);
  return d_a * half * std::cos(std::atan(std::tan(beta) * d_a / d));
}

template <class Tracer>
void tips(const Input& in, Result& r, Tracer& trace) {
  const double s_a1 = trace.value("s_a1", tip_thickness(in, in.z_1, in.beta_1, in.x_1), "tip of gear 1, in modules");
  const double s_a2 = trace.value("s_a2", tip_thickness(in, in.z_2, in.beta_2, -in.x_1), "tip of gear 2, in modules");
  STEP_TO(r, s_a, min(s_a1, s_a2), "the smaller one");
}

}  // namespace loadpath::gear::crossed
