// Form, rim and permissible root stress of [ISO6336-3], edition 2006, method B, as restated in [IACS-M56].
#pragma once

#include "calculators/gear/rating/iso_flank.hpp"
#include "calculators/gear/rating/root_form.hpp"

namespace loadpath::gear::rating {

/// Share of the load at the outer point of single contact, [ISO6336-3-2019].
template <class Tracer>
double load_distribution(double eps_an, const PairResult& g, Tracer& trace) {
  const double eps_beta = trace.value("eps_beta", g.eps_beta, "overlap ratio");
  if (eps_beta <= 0.0) {
    return trace.value("f_eps", eps_an < 2.0 ? 1.0 : 0.7, "spur gears: 0.7 from eps_an of 2 on, [ISO6336-3-2019]");
  }
  const double n_p = trace.value("n_p", eps_an < 2.0 ? 1.0 : 2.0, "minimum number of pairs of spur teeth in contact");
  STEP(s_beta, min(eps_beta, 1.0), "overlap ratio, 1 at most");
  return NAMED_STEP("f_eps", sqrt((1.0 - s_beta) / n_p + s_beta / eps_an),
                    "load distribution influence factor, [ISO6336-3-2019]");
}

/// The load at the outer point of single pair contact, which needs no Y_eps.
template <class Tracer>
Form form_of_iso(const Input& in, const PairResult& g, const Wheel& wheel, const RootFillet& fillet, Tracer& trace) {
  const double z_n = fillet.z_n;
  const Length d = wheel.d, d_a = wheel.d_a;
  const double eps_alpha = trace.value("eps_alpha", g.eps_alpha, "transverse contact ratio");
  const double beta_b = trace.angle("beta_b", std::acos(cos_of_base_helix(in, g)), "base helix angle");
  STEP(eps_an, eps_alpha / pow<2>(cos(beta_b)), "contact ratio of the virtual gears");
  STEP(d_an, z_n + (d_a - d) / in.m_n, "tip circle of the virtual gear, in modules");
  STEP(d_bn, z_n * cos(in.alpha_n), "its base circle, in modules");
  STEP(t_en, sqrt(pow<2>(d_an / 2.0) - pow<2>(d_bn / 2.0)) - pi * cos(in.alpha_n) * (eps_an - 1.0),
       "radius of the flank at the outer point of single pair contact, in modules");
  STEP(d_en, 2.0 * sqrt(pow<2>(t_en) + pow<2>(d_bn / 2.0)), "circle of that point, [ISO6336-3] 2006, 6.2");
  Form form = form_at(in, wheel, fillet, d_en, trace);
  if (in.root_edition == RootEdition::of_2019) {
    const double Y_F = form.Y_F, f_eps = form.f_eps = load_distribution(eps_an, g, trace);
    form.Y_F = NAMED_STEP(wheel.symbols.Y_F, Y_F * f_eps, "of this gear, [ISO6336-3-2019]");
  } else {
    form.Y_F = trace.value(wheel.symbols.Y_F, form.Y_F, "of this gear, [ISO6336-3] 2006, clause 6");
  }
  form.Y_S = trace.value(wheel.symbols.Y_S, form.Y_S, "of this gear, [ISO6336-3] 2006, clause 7");
  return form;
}

/// Y_B of a rim: 1 of a solid gear.
template <class Tracer>
double rim_factor(const Wheel& wheel, Tracer& trace) {
  if (!is_set(wheel.s_R)) return trace.value("Y_B", 1.0, "rim thickness factor, no rim stated");
  const Length s_R = trace.value("s_R", wheel.s_R, "rim thickness of this gear");
  const Length d_a = wheel.d_a, d_f = trace.value("d_f", wheel.d_f, "root circle");
  trace.value("d_a", d_a, "tip circle");
  STEP(h_t, (d_a - d_f) / 2.0, "tooth depth");
  return NAMED_STEP("Y_B", s_R / h_t < 1.2 ? 1.6 * log(2.242 * h_t / s_R) : 1.0,
                    "rim thickness factor, [ISO6336-3] 2006, clause 9");
}

/// Y_X of large modules, [DIN3990-3], [ISO6336-3] clause 15; of grey iron `least` at least.
inline double size_factor_of_root(GearMaterial material, double m, double least) {
  if (material == GearMaterial::grey) return std::min(1.0, std::max(1.075 - 0.015 * m, least));
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

/// The life factor of a static load, and the cycles up to which it holds.
inline double static_life(GearMaterial material) {
  return is_nitrided(material) || material == GearMaterial::grey ? 1.6 : 2.5;
}
inline double static_cycles(GearMaterial material) {
  return is_hardened(material) || material == GearMaterial::grey ? 1e3 : 1e4;
}

/// Slip-layer thickness, mm, of the less favourable strength of the group: the thickest below the notch of the test
/// gear, q_s of 2.5, the thinnest above. [ISO6336-3] 2006, clause 13.
inline double slip_layer(GearMaterial material, double q_s) {
  const bool is_blunt = q_s < 2.5;
  switch (material) {
    case GearMaterial::steel:
      return is_blunt ? 0.0833 : 0.0445;
    case GearMaterial::nodular:
      return is_blunt ? 0.3124 : 0.0014;
    case GearMaterial::grey:
      return is_blunt ? 0.3124 : 0.3095;
    case GearMaterial::through_carbon:
    case GearMaterial::through_alloy:
      return is_blunt ? 0.0281 : 0.0014;
    case GearMaterial::case_hardened:
    case GearMaterial::induction:
      return 0.0030;
    case GearMaterial::nitrided:
    case GearMaterial::nitrided_through:
      break;
  }
  return 0.1005;
}

/// Y_RrelT by the roughness of the flanks; a root smoother than that of the test gear, 10 um, is not an advantage.
inline double root_surface(GearMaterial material, Length R_z) {
  const double rough = std::max(R_z / um, 10.0) + 1.0;
  if (material == GearMaterial::steel) return std::min(1.0, 5.306 - 4.203 * std::pow(rough, 0.01));
  if (is_nitrided(material) || material == GearMaterial::grey)
    return std::min(1.0, 4.299 - 3.259 * std::pow(rough, 0.0058));
  return std::min(1.0, 1.674 - 0.529 * std::pow(rough, 0.1));
}

/// Permissible root stress of one gear with S_Fmin of 1; at rest the roughness and the size count for nothing.
template <class Tracer>
LifeLimit root_limit_iso(const Input& in, const Wheel& wheel, const Form& form, Stress sigma_Flim, double N,
                         Tracer& trace) {
  const double q_s = trace.value("q_s", form.q_s, "notch parameter of this gear");
  const double rho_s = trace.value("rho_s", slip_layer(wheel.material, q_s), "slip-layer thickness, mm");
  STEP(Y_delta, (1.0 + sqrt(0.2 * rho_s * (1.0 + 2.0 * q_s))) / (1.0 + sqrt(1.2 * rho_s)),
       "relative notch sensitivity, [ISO6336-3] 2006, clause 13");
  const double Y_R = trace.value("Y_R", root_surface(wheel.material, wheel.R_z),
                                 "relative surface factor of the root, [ISO6336-3] 2006, clause 14");
  const double Y_X = trace.value("Y_X", size_factor_of_root(wheel.material, in.m_n / mm, 0.7),
                                 "size factor, [ISO6336-3] 2006, clause 15");
  const double Y_A = trace.value("Y_A", wheel.both_ways ? 0.7 : 1.0, "0.7 for reversed bending, [ISO6336-5]");
  STEP(sigma_Fref, 2.0 * sigma_Flim * Y_delta * Y_R * Y_X * Y_A, "reference stress of the root, with Y_ST of 2");
  constexpr double knee = 3e6;
  double life = beyond_knee(N, knee);
  if (is_set(N) && N < knee) {
    const double few = static_cycles(wheel.material);
    const Stress at_rest =
        2.0 * static_life(wheel.material) * static_sensitivity(wheel.material, form.Y_S) * Y_A * sigma_Flim;
    const double rise = at_rest / sigma_Fref;
    life = std::pow(std::max(1.0, rise), std::log(knee / std::max(N, few)) / std::log(knee / few));
  }
  const double Y_NT = trace.value(wheel.symbols.Y_NT, life,
                                  is_set(N) ? "life factor at the cycles of the gear, [ISO6336-3] 2006, clause 12"
                                            : "life factor of 1e10 cycles, no life given, [ISO6336-3] 2006, clause 12");
  trace.value("Y_NT", Y_NT, "of this gear");
  STEP(sigma_FG, sigma_Fref * Y_NT, "tooth root stress limit, [ISO6336-3] 2006, 5.3");
  return {sigma_FG, Y_NT};
}

}  // namespace loadpath::gear::rating
