// Bending stress of the tooth root, [DIN3990-3] method C, and what it may be.
#pragma once

#include "calculators/gear/rating/contact.hpp"

namespace loadpath::gear::rating {

struct Form {
  double Y_Fa = unset<double>, Y_Sa = unset<double>, q_s = unset<double>;
};

/// The angle of the point of the fillet whose tangent leans by 30 degrees: theta = 2 G/z_n tan(theta) - H.
inline double fillet_angle(double G, double H, double z_n) {
  double theta = pi / 6.0;
  for (int i = 0; i < 60; ++i) {
    const double f = theta - 2.0 * G / z_n * std::tan(theta) + H;
    const double slope = 1.0 - 2.0 * G / z_n / (std::cos(theta) * std::cos(theta));
    theta -= f / slope;
  }
  return theta;
}

/// Form factor and stress correction of a load at the tip, of the spur gear with the same normal section.
template <class Tracer>
Form form_of(const Input& in, const PairResult& g, const Wheel& wheel, Tracer& trace) {
  const double z = trace.value("z", wheel.z, "teeth of this gear"), x = trace.value("x", wheel.x, "its profile shift");
  const Length d = trace.value("d", wheel.d, "reference circle"), d_a = trace.value("d_a", wheel.d_a, "tip circle");
  const double beta_b = trace.angle("beta_b", std::acos(cos_of_base_helix(in, g)), "base helix angle");
  STEP(z_n, z / (pow<2>(cos(beta_b)) * cos(in.beta)), "teeth of the virtual spur gear");
  STEP(E, pi / 4.0 - in.h_fP * tan(in.alpha_n) - (1.0 - sin(in.alpha_n)) * in.rho_fP / cos(in.alpha_n),
       "auxiliary value, in modules");
  STEP(G, in.rho_fP - in.h_fP + x, "auxiliary value");
  STEP(H, 2.0 / z_n * (pi / 2.0 - E) - pi / 3.0, "auxiliary value");
  const double theta = trace.angle("theta", fillet_angle(G, H, z_n), "root of theta = 2 G/z_n tan(theta) - H");
  STEP(s_Fn, z_n * sin(pi / 3.0 - theta) + sqrt(3.0) * (G / cos(theta) - in.rho_fP),
       "chord of the root at the 30 degree tangent, in modules");
  STEP(rho_F, in.rho_fP + 2.0 * G * G / (cos(theta) * (z_n * pow<2>(cos(theta)) - 2.0 * G)),
       "radius of the fillet there, in modules");
  STEP(d_an, z_n + (d_a - d) / in.m_n, "tip circle of the virtual gear, in modules");
  STEP(alpha_an, acos(z_n * cos(in.alpha_n) / d_an), "pressure angle at its tip");
  STEP(gamma_a, (pi / 2.0 + 2.0 * x * tan(in.alpha_n)) / z_n + tan(in.alpha_n) - in.alpha_n - tan(alpha_an) + alpha_an,
       "half of the tip thickness angle");
  STEP(alpha_Fan, alpha_an - gamma_a, "direction of the load at the tip");
  STEP(h_Fa,
       ((cos(gamma_a) - sin(gamma_a) * tan(alpha_Fan)) * d_an - z_n * cos(pi / 3.0 - theta) - G / cos(theta) +
        in.rho_fP) /
           2.0,
       "bending arm, in modules");
  Form form;
  STEP(Y_Fa, 6.0 * h_Fa * cos(alpha_Fan) / (pow<2>(s_Fn) * cos(in.alpha_n)), "form factor, load at the tip");
  form.Y_Fa = trace.value(wheel.symbols.Y_Fa, Y_Fa, "of this gear");
  STEP(L_a, s_Fn / h_Fa, "chord over arm");
  STEP(q_s, s_Fn / (2.0 * rho_F), "notch parameter");
  form.q_s = q_s;
  STEP(e_S, 1.0 / (1.21 + 2.3 / L_a), "exponent");
  const double Y_Sa = trace.value("Y_Sa", (1.2 + 0.13 * L_a) * std::pow(q_s, e_S),
                                  "stress correction factor, (1.2 + 0.13 L_a) q_s^e_S");
  form.Y_Sa = trace.value(wheel.symbols.Y_Sa, Y_Sa, "of this gear");
  return form;
}

template <class Tracer>
void root_factors(const Input& in, const PairResult& g, Result& r, Tracer& trace) {
  const double eps_alpha = trace.value("eps_alpha", g.eps_alpha, "transverse contact ratio");
  const double eps_beta = trace.value("eps_beta", g.eps_beta, "overlap ratio");
  const double beta_b = trace.angle("beta_b", std::acos(cos_of_base_helix(in, g)), "base helix angle");
  STEP_TO(r, Y_eps, 0.25 + 0.75 * pow<2>(cos(beta_b)) / eps_alpha, "contact ratio factor");
  STEP_TO(r, Y_beta, 1.0 - min(eps_beta, 1.0) * min(in.beta, pi / 6.0) / (2.0 * pi / 3.0), "helix factor");
}

/// Y_X of large modules, [DIN3990-3].
inline double size_factor_of_root(GearMaterial material, double m) {
  if (material == GearMaterial::grey) return std::min(1.0, std::max(1.075 - 0.015 * m, 0.85));
  if (is_hardened(material)) return std::min(1.0, std::max(1.05 - 0.01 * m, 0.8));
  return std::min(1.0, std::max(1.03 - 0.006 * m, 0.85));
}

/// Relative notch sensitivity of a static load, [DIN3990-11]; of steels that are not hardened by a yield strength of
/// 200 MPa, the least favourable one.
inline double static_sensitivity(GearMaterial material, double Y_S) {
  constexpr double by_yield = 0.9075;  // 0.82 (300/200)^0.25
  if (material == GearMaterial::grey) return 1.0;
  if (material == GearMaterial::nodular) return 0.07 * Y_S + 0.86;
  if (is_nitrided(material)) return 0.20 * Y_S + 0.60;
  if (is_hardened(material)) return 0.44 * Y_S + 0.12;
  return (1.0 + by_yield * (Y_S - 1.0)) / (1.0 + by_yield);
}

struct Root {
  Stress sigma_0 = unset<Stress>, sigma = unset<Stress>, limit = unset<Stress>;
  double S = unset<double>, u = unset<double>;
};

template <class Tracer>
Root root_of(const Input& in, const Wheel& wheel, const Form& form, double K_Fbeta_of, Stress lim, double N,
             const Result& r, Tracer& trace) {
  Root root;
  const Force F_t = r.F_t;
  const double Y_Fa = form.Y_Fa, Y_Sa = form.Y_Sa, Y_eps = r.Y_eps, Y_beta = r.Y_beta;
  trace.value("Y_Fa", Y_Fa, "form factor of this gear");
  trace.value("Y_Sa", Y_Sa, "its stress correction factor");
  STEP(sigma_F0, F_t / (in.b * in.m_n) * Y_Fa * Y_Sa * Y_eps * Y_beta, "nominal root stress, [DIN3990-3]");
  root.sigma_0 = trace.value(wheel.symbols.sigma_F0, sigma_F0, "of this gear");
  const double K_V = r.K_V, K_Falpha = r.K_Falpha;
  const double K_Fbeta = trace.value("K_Fbeta", K_Fbeta_of, "face load factor of this gear");
  STEP(sigma_F, sigma_F0 * in.K_A * K_V * K_Fbeta * K_Falpha, "root stress");
  root.sigma = trace.value(wheel.symbols.sigma_F, sigma_F, "of this gear");
  const Stress sigma_Flim = trace.value("sigma_Flim", lim, "allowable stress number of this gear");
  const double Y_X = trace.value("Y_X", size_factor_of_root(wheel.material, in.m_n / mm), "size factor");
  const double Y_delta =
      trace.value("Y_delta", form.q_s >= 1.5 ? 1.0 : 0.95, "relative notch sensitivity, [DIN3990-11]");
  const double Y_R = trace.value("Y_R", wheel.R_z > 16.0 * um.one ? 0.9 : 1.0, "roughness of the root, [DIN3990-11]");
  const double Y_A = trace.value("Y_A", wheel.both_ways ? 0.7 : 1.0, "0.7 for reversed bending");
  STEP(sigma_Fend, 2.0 * sigma_Flim * Y_delta * Y_R * Y_X * Y_A, "endurance limit of the root, with Y_ST of 2");
  const bool is_short = is_nitrided(wheel.material) || wheel.material == GearMaterial::grey;
  const double Y_S = Y_Sa * (0.6 + 0.4 * 0.75 / (Y_eps - 0.25));
  const double Y_stat = (is_short ? 1.6 : 2.5) * static_sensitivity(wheel.material, Y_S);
  const Stress sigma_FG = limit_at(sigma_Fend, 2.0 * Y_stat * Y_A * sigma_Flim, N,
                                   is_short || is_hardened(wheel.material) ? 1e3 : 1e4, 3e6, trace, "sigma_FG");
  root.limit = trace.value(wheel.symbols.sigma_FG, sigma_FG, "of this gear");
  const double S_F = root.S =
      NAMED_STEP(wheel.symbols.S_F, sigma_FG / sigma_F, "calculated safety factor against tooth breakage");
  trace.value("S_F", S_F, "this safety factor");
  if (is_set(in.S_Fmin)) root.u = NAMED_STEP(wheel.symbols.u_F, in.S_Fmin / S_F, "required / calculated safety factor");
  return root;
}

}  // namespace loadpath::gear::rating
