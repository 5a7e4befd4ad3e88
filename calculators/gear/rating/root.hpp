// Bending stress of the tooth root, [DIN3990-3] method C or [ISO6336-3] of 2006, and what it may be.
#pragma once

#include "calculators/gear/rating/contact.hpp"
#include "calculators/gear/rating/iso_root.hpp"

namespace loadpath::gear::rating {

/// The load at the tip.
template <class Tracer>
Form form_of_din(const Input& in, const Wheel& wheel, const RootFillet& fillet, Tracer& trace) {
  const double z_n = fillet.z_n;
  const Length d = wheel.d, d_a = wheel.d_a;
  STEP(d_an, z_n + (d_a - d) / in.m_n, "tip circle of the virtual gear, in modules");
  Form form = form_at(in, wheel, fillet, trace.value("d_en", d_an, "circle of the load: the tip"), trace);
  form.Y_F = trace.value(wheel.symbols.Y_Fa, form.Y_F, "of this gear, load at the tip");
  form.Y_S = trace.value(wheel.symbols.Y_Sa, form.Y_S, "of this gear, load at the tip");
  return form;
}

template <class Tracer>
Form form_of(const Input& in, const PairResult& g, const Wheel& wheel, Tracer& trace) {
  const RootFillet fillet = fillet_of(in, g, wheel, trace);
  return is_iso(in) ? form_of_iso(in, g, wheel, fillet, trace) : form_of_din(in, wheel, fillet, trace);
}

template <class Tracer>
void root_factors(const Input& in, const PairResult& g, Result& r, Tracer& trace) {
  const double eps_alpha = trace.value("eps_alpha", g.eps_alpha, "transverse contact ratio");
  const double eps_beta = trace.value("eps_beta", g.eps_beta, "overlap ratio");
  const double beta_b = trace.angle("beta_b", std::acos(cos_of_base_helix(in, g)), "base helix angle");
  STEP_TO(r, Y_eps, 0.25 + 0.75 * pow<2>(cos(beta_b)) / eps_alpha, "contact ratio factor");
  if (in.root_edition == RootEdition::of_2019) {
    STEP_TO(r, Y_beta, (1.0 - min(eps_beta, 1.0) * min(in.beta, pi / 6.0) / (2.0 * pi / 3.0)) / pow<3>(cos(in.beta)),
            "helix factor, [ISO6336-3-2019]");
  } else {
    STEP_TO(r, Y_beta, 1.0 - min(eps_beta, 1.0) * min(in.beta, pi / 6.0) / (2.0 * pi / 3.0), "helix factor");
  }
}

/// Permissible root stress of one gear by [DIN3990-11].
template <class Tracer>
LifeLimit root_limit_din(const Input& in, const Wheel& wheel, const Form& form, Stress sigma_Flim, double N,
                         const Result& r, Tracer& trace) {
  const double Y_Sa = form.Y_S, Y_eps = r.Y_eps;
  const double Y_X = trace.value("Y_X", size_factor_of_root(wheel.material, in.m_n / mm, 0.85), "size factor");
  const double Y_delta =
      trace.value("Y_delta", form.q_s >= 1.5 ? 1.0 : 0.95, "relative notch sensitivity, [DIN3990-11]");
  const double Y_R = trace.value("Y_R", wheel.R_z > 16.0 * um.one ? 0.9 : 1.0, "roughness of the root, [DIN3990-11]");
  const double Y_A = trace.value("Y_A", wheel.both_ways ? 0.7 : 1.0, "0.7 for reversed bending");
  STEP(sigma_Fend, 2.0 * sigma_Flim * Y_delta * Y_R * Y_X * Y_A, "endurance limit of the root, with Y_ST of 2");
  const double Y_S = Y_Sa * (0.6 + 0.4 * 0.75 / (Y_eps - 0.25));
  const double Y_stat = static_life(wheel.material) * static_sensitivity(wheel.material, Y_S);
  return {
      limit_at(sigma_Fend, 2.0 * Y_stat * Y_A * sigma_Flim, N, static_cycles(wheel.material), 3e6, trace, "sigma_FG")};
}

struct Root {
  Stress sigma_0 = unset<Stress>, sigma = unset<Stress>, limit = unset<Stress>;
  double S = unset<double>, u = unset<double>, Y_B = unset<double>, Y_NT = unset<double>;
};

template <class Tracer>
Stress nominal_root(const Input& in, const Wheel& wheel, const Form& form, const Result& r, Root& root, Tracer& trace) {
  const Force F_t = r.F_t;
  const double Y_beta = r.Y_beta;
  if (is_iso(in)) {
    const double Y_F = trace.value("Y_F", form.Y_F, "form factor of this gear");
    const double Y_S = trace.value("Y_S", form.Y_S, "its stress correction factor");
    const double Y_B = rim_factor(wheel, trace);
    root.Y_B = trace.value(wheel.symbols.Y_B, Y_B, "of this gear");
    const double Y_DT = trace.value("Y_DT", 1.0, "deep tooth factor, grades above 4, [ISO6336-3] 2006, clause 10");
    return NAMED_STEP("sigma_F0", F_t / (in.b * in.m_n) * Y_F * Y_S * Y_beta * Y_B * Y_DT,
                      "nominal root stress, [ISO6336-3] 2006, 5.2");
  }
  const double Y_Fa = form.Y_F, Y_Sa = form.Y_S, Y_eps = r.Y_eps;
  trace.value("Y_Fa", Y_Fa, "form factor of this gear");
  trace.value("Y_Sa", Y_Sa, "its stress correction factor");
  return NAMED_STEP("sigma_F0", F_t / (in.b * in.m_n) * Y_Fa * Y_Sa * Y_eps * Y_beta,
                    "nominal root stress, [DIN3990-3]");
}

template <class Tracer>
Root root_of(const Input& in, const Wheel& wheel, const Form& form, double K_Fbeta_of, Stress lim, double N,
             const Result& r, Tracer& trace) {
  Root root;
  const Stress sigma_F0 = nominal_root(in, wheel, form, r, root, trace);
  root.sigma_0 = trace.value(wheel.symbols.sigma_F0, sigma_F0, "of this gear");
  const double K_V = r.K_V, K_Falpha = r.K_Falpha;
  const double K_Fbeta = trace.value("K_Fbeta", K_Fbeta_of, "face load factor of this gear");
  STEP(sigma_F, sigma_F0 * in.K_A * K_V * K_Fbeta * K_Falpha, "root stress");
  root.sigma = trace.value(wheel.symbols.sigma_F, sigma_F, "of this gear");
  if (!in.blocks.empty()) return root;  // its limit is one of damage
  const Stress sigma_Flim = trace.value("sigma_Flim", lim, "allowable stress number of this gear");
  const LifeLimit limit = is_iso(in) ? root_limit_iso(in, wheel, form, sigma_Flim, N, trace)
                                     : root_limit_din(in, wheel, form, sigma_Flim, N, r, trace);
  const Stress sigma_FG = limit.sigma;
  root.Y_NT = limit.factor;
  root.limit = trace.value(wheel.symbols.sigma_FG, sigma_FG, "of this gear");
  const double S_F = root.S =
      NAMED_STEP(wheel.symbols.S_F, sigma_FG / sigma_F, "calculated safety factor against tooth breakage");
  trace.value("S_F", S_F, "this safety factor");
  if (is_set(in.S_Fmin)) root.u = NAMED_STEP(wheel.symbols.u_F, in.S_Fmin / S_F, "required / calculated safety factor");
  return root;
}

}  // namespace loadpath::gear::rating
