// The fillet of a tooth, and its form factor and stress correction under a load at a circle: [DIN3990-3] and
// [ISO6336-3] differ only in the circle.
#pragma once

#include "calculators/gear/rating/contact.hpp"

namespace loadpath::gear::rating {

struct Form {
  double Y_F = unset<double>, Y_S = unset<double>, q_s = unset<double>, f_eps = unset<double>;
};

/// The fillet at the point whose tangent leans by 30 degrees, in modules.
struct RootFillet {
  double z_n, G, theta, s_Fn, rho_F;
};

/// The angle of the point of the fillet whose tangent leans by 30 degrees: theta = 2 G/z_n tan(theta) - H.
inline double fillet_angle(double G, double H, double z_n) {
  double theta = pi / 6.0;
  for (int i = 0; i < 60; ++i) {
    const double f = theta - 2.0 * G / z_n * std::tan(theta) + H;
    const double slope = 1.0 - 2.0 * G / z_n / (std::cos(theta) * std::cos(theta));
    const double next = theta - f / slope;
    if (next == theta) break;  // further steps would repeat it
    theta = next;
  }
  return theta;
}

/// Half of the tool tooth between the centres of its tip roundings; a protuberance moves them apart.
template <class Tracer>
double rounding_centre(const Input& in, Tracer& trace) {
  if (is_set(in.s_pr)) {
    return NAMED_STEP("E",
                      pi / 4.0 - in.h_fP * tan(in.alpha_n) + in.s_pr / cos(in.alpha_n) -
                          (1.0 - sin(in.alpha_n)) * in.rho_fP / cos(in.alpha_n),
                      "auxiliary value, in modules, with the residual undercut s_pr");
  }
  return NAMED_STEP("E", pi / 4.0 - in.h_fP * tan(in.alpha_n) - (1.0 - sin(in.alpha_n)) * in.rho_fP / cos(in.alpha_n),
                    "auxiliary value, in modules");
}

template <class Tracer>
RootFillet fillet_of(const Input& in, const PairResult& g, const Wheel& wheel, Tracer& trace) {
  const double z = trace.value("z", wheel.z, "teeth of this gear"), x = trace.value("x", wheel.x, "its profile shift");
  trace.value("d", wheel.d, "reference circle"), trace.value("d_a", wheel.d_a, "tip circle");
  const double beta_b = trace.angle("beta_b", std::acos(cos_of_base_helix(in, g)), "base helix angle");
  STEP(z_n, z / (pow<2>(cos(beta_b)) * cos(in.beta)), "teeth of the virtual spur gear");
  const double E = rounding_centre(in, trace);
  STEP(G, in.rho_fP - in.h_fP + x, "auxiliary value");
  STEP(H, 2.0 / z_n * (pi / 2.0 - E) - pi / 3.0, "auxiliary value");
  const double theta = trace.angle("theta", fillet_angle(G, H, z_n), "root of theta = 2 G/z_n tan(theta) - H");
  STEP(s_Fn, z_n * sin(pi / 3.0 - theta) + sqrt(3.0) * (G / cos(theta) - in.rho_fP),
       "chord of the root at the 30 degree tangent, in modules");
  STEP(rho_F, in.rho_fP + 2.0 * G * G / (cos(theta) * (z_n * pow<2>(cos(theta)) - 2.0 * G)),
       "radius of the fillet there, in modules");
  return {z_n, G, theta, s_Fn, rho_F};
}

/// The load at the circle d_en of the spur gear with the same normal section, in modules.
template <class Tracer>
Form form_at(const Input& in, const Wheel& wheel, const RootFillet& fillet, double d_en, Tracer& trace) {
  const double x = wheel.x, z_n = fillet.z_n, G = fillet.G, theta = fillet.theta, s_Fn = fillet.s_Fn;
  const double rho_F = fillet.rho_F;
  STEP(alpha_en, acos(z_n * cos(in.alpha_n) / d_en), "pressure angle at the circle of the load");
  STEP(gamma_e, (pi / 2.0 + 2.0 * x * tan(in.alpha_n)) / z_n + tan(in.alpha_n) - in.alpha_n - tan(alpha_en) + alpha_en,
       "half of the thickness angle there");
  STEP(alpha_Fen, alpha_en - gamma_e, "direction of the load");
  STEP(h_Fe,
       ((cos(gamma_e) - sin(gamma_e) * tan(alpha_Fen)) * d_en - z_n * cos(pi / 3.0 - theta) - G / cos(theta) +
        in.rho_fP) /
           2.0,
       "bending arm, in modules");
  STEP(Y_F, 6.0 * h_Fe * cos(alpha_Fen) / (pow<2>(s_Fn) * cos(in.alpha_n)), "form factor");
  STEP(L_e, s_Fn / h_Fe, "chord over arm");
  STEP(q_s, s_Fn / (2.0 * rho_F), "notch parameter");
  STEP(Y_S, (1.2 + 0.13 * L_e) * pow(q_s, 1.0 / (1.21 + 2.3 / L_e)), "stress correction factor");
  return {Y_F, Y_S, q_s, unset<double>};
}

}  // namespace loadpath::gear::rating
