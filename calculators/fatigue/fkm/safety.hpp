// From the nominal stresses of a section to its utilisations in fatigue and under the largest load by [FKM].
//
// fkm_section(steel, section, loads, service, trace) rates one section. Tension is positive. In bending and torsion the
// sign is of no account: a round section has a fibre of each sign.
#pragma once

#include "calculators/fatigue/din743/safety.hpp"
#include "calculators/fatigue/fkm/mean.hpp"
#include "calculators/fatigue/fkm/notch.hpp"

#include <cmath>

namespace loadpath::fatigue {

/// Where the lines of finite life end.
inline constexpr double fkm_knee = 1e6;

template <class Tracer>
double slope_of_life(Stressing kind, Tracer& trace) {
  return trace.value("k", kind == Stressing::torsion ? 8.0 : 5.0,
                     "slope of finite life, 5, in torsion 8, [FKM] 2.4, not checked against the source");
}

/// Amplitude over its limit, and the resulting life.
template <class Tracer>
void hold_amplitude(const FkmService& l, Stressing kind, FkmStress& k, Tracer& trace) {
  using std::pow;
  if (!(k.sigma_a > 0.0 * MPa)) {
    k.a = trace.value("a", 0.0, "this stress does not vary");
    return;
  }
  k.K_AK = mean_stress_factor(l.overload, k, trace);
  const double K_AK = k.K_AK;
  const Stress sigma_WK = k.sigma_WK, sigma_a = k.sigma_a;
  STEP_TO(k, sigma_AK, K_AK * sigma_WK, "at this mean stress, [FKM] 2.4");
  const double slope = slope_of_life(kind, trace),
               N_D = trace.value("N_D", fkm_knee, "knee, [FKM] 2.4, not checked against the source");
  k.K_BK = is_set(l.N) && l.N < N_D ? pow(N_D / l.N, 1.0 / slope) : 1.0;
  const double K_BK = trace.value("K_BK", k.K_BK, "(N_D/N)^(1/k) up to the knee, [FKM] 2.4");
  STEP_TO(k, sigma_BK, K_BK * sigma_AK, "for the required life, [FKM] 2.4");
  const double j_D = l.j_D;
  STEP_TO(k, a, sigma_a * j_D / sigma_BK, "utilisation, [FKM] 2.6");
  const double over = j_D * sigma_a / sigma_AK;
  k.N_a = trace.value("N_a", over > 1.0 ? N_D * pow(over, -slope) : std::numeric_limits<double>::infinity(),
                      "N_D (sigma_AK/(j_D sigma_a))^k above its limit, without end below");
}

/// Load of a fully plastic section over that where yielding begins: exact for rings, 16/(3 pi) and 4/3 where
/// solid.
template <class Tracer>
double plastic_factor(const Din743Section& s, Stressing kind, Tracer& trace) {
  const bool even = kind == Stressing::tension || s.layer == Layer::hard || s.notch == Notch::cross_hole;
  if (even) return trace.value("K_p", 1.0, "even stress, a hard layer, or a section with a hole: no support");
  STEP(chi, s.d_bore / s.d, "bore over diameter");
  if (kind == Stressing::bending)
    return NAMED_STEP("K_p", 16.0 / (3.0 * pi) * (1.0 - pow<3>(chi)) / (1.0 - pow<4>(chi)),
                      "plastic limit load over elastic one, bending, [FKM] 1.3");
  return NAMED_STEP("K_p", 4.0 / 3.0 * (1.0 - pow<3>(chi)) / (1.0 - pow<4>(chi)),
                    "plastic limit load over elastic one, torsion, [FKM] 1.3");
}

template <class Tracer>
void static_strength(const Din743Section& s, const FkmSteel& steel, const FkmService& l, Stress yield, Stressing kind,
                     FkmStress& k, Tracer& trace) {
  const Stress R_ed = yield, R_pmax = l.R_pmax;
  const double K_p = plastic_factor(s, kind, trace);
  STEP(n_e, sqrt(R_pmax / R_ed), "by the allowable strain, Neuber, [FKM] 1.3, not checked against the source");
  STEP_TO(k, n_pl, min(max(n_e, 1.0), K_p), "plastic support, no more than the section has, [FKM] 1.3");
  const double f_S =
      trace.value("f_S", kind == Stressing::torsion ? fkm_row(steel.steel).tau : 1.0, "shear over normal, [FKM] 1.2");
  STEP_TO(k, sigma_SK, f_S * n_pl * R_ed, "static strength of the section, [FKM] 1.4");
}

/// All that can be said of one stress before the others are known.
template <class Tracer>
FkmStress stress_of_section(const FkmSteel& steel, const Din743Section& s, const Din743Loads& loads,
                            const FkmService& l, const Din743Acting& acting, FkmRoot root, FkmSafety& r,
                            Tracer& trace) {
  FkmStress k;
  Din743Stress nominal;
  nominal_stresses(s, loads, acting.kind, nominal, trace);
  k.name = acting.name;
  k.sigma_m = nominal.sigma_m, k.sigma_a = nominal.sigma_a, k.sigma_max = nominal.sigma_max;
  root.f_W = shear_over_normal(steel, acting.kind == Stressing::torsion, trace);
  const Twist steep = fkm_design_factor(s, steel.steel, l, root, acting.kind, k, trace);
  if (is_set(steep)) {
    const double x = steep * (0.01 * mm);
    r.x_G = is_set(r.x_G) ? std::max(r.x_G, x) : x;
  }
  k.sigma_W = fkm_limit(steel, acting.kind == Stressing::torsion, root.f_W, r.R_md, trace);
  const Stress sigma_W = k.sigma_W;
  const double K_WK = k.K_WK;
  STEP_TO(k, sigma_WK, sigma_W / K_WK, "fatigue limit of the section, R = −1, [FKM] 2.4");
  k.M = fkm_sensitivity(steel, root.f_W, r.R_md, trace);
  static_strength(s, steel, l, r.R_ed, acting.kind, k, trace);
  return k;
}

/// The mean stress that each of them is held with.
template <class Tracer>
void mean_stresses(const FkmSteel& steel, const FkmService& l, FkmSafety& r, Tracer& trace) {
  if (l.means == Means::each) {
    for (FkmStress& k : r.stresses) k.sigma_mv = k.sigma_m;
    return;
  }
  r.sigma_mv = mean_as_one(r, &FkmStress::sigma_m,
                           "one mean stress for all, of both signs, [FKM] 2.4, not checked against the source", trace);
  const Stress sigma_mv = r.sigma_mv;
  const double f_W = trace.value("f_W", fkm_row(steel.steel).tau, "shear over normal, [FKM] 2.2");
  STEP_TO(r, tau_mv, f_W * max(sigma_mv, 0.0 * MPa), "as shear, none where it presses");
  for (FkmStress& k : r.stresses) k.sigma_mv = k.name == Name("torsion") ? r.tau_mv : r.sigma_mv;
}

/// Utilisations as one: between the hypotheses of the largest normal stress and of von Mises.
template <class Tracer>
double combined(const char* symbol, FkmSafety& r, double FkmStress::*at, bool keep, Tracer& trace) {
  const double a_GH = together("a_GH", r, at, "von Mises, stresses in phase, [FKM] 2.6", trace);
  const double v_zd = of_stress(r, "tension", at, 0.0), v_b = of_stress(r, "bending", at, 0.0);
  const double v_t = of_stress(r, "torsion", at, 0.0);
  STEP(a_NH, 0.5 * (v_zd + v_b + sqrt(pow<2>(v_zd + v_b) + 4.0 * pow<2>(v_t))), "maximum normal stress, [FKM] 2.6");
  if (keep) r.a_NH = a_NH, r.a_GH = a_GH;
  const double q = r.q;
  return NAMED_STEP(symbol, q * a_NH + (1.0 - q) * a_GH, "between both hypotheses, [FKM] 2.6");
}

template <class Tracer>
void ductility(const FkmSteel& steel, const Din743Section& s, FkmSafety& r, Tracer& trace) {
  if (s.layer == Layer::hard) {
    r.q = trace.value("q", 1.0, "brittle under a hard layer, which is on the safe side");
    return;
  }
  const double f_W = trace.value("f_W", fkm_row(steel.steel).tau, "shear over normal, [FKM] 2.2");
  STEP_TO(r, q, max((sqrt(3.0) - 1.0 / f_W) / (sqrt(3.0) - 1.0), 0.0),
          "0: ductile, 1: brittle, [FKM] 2.6, not checked against the source");
}

template <class Tracer>
void static_utilisation(const FkmService& l, FkmSafety& r, Tracer& trace) {
  const double j_m = l.j_m, j_p = l.j_p;
  const Stress R_ed = r.R_ed, R_md = r.R_md;
  STEP(j_my, j_m * R_ed / R_md, "against fracture, held against the yield limit, [FKM] 1.5");
  STEP_TO(r, j_ges, max(j_my, j_p), "against fracture and yielding, [FKM] 1.5");
  bool complete = !r.stresses.empty();
  for (std::size_t i = 0; i < r.stresses.size(); ++i) {
    FkmStress& k = r.stresses[i];
    complete = complete && is_set(k.sigma_max);
    if (!is_set(k.sigma_max)) continue;
    [[maybe_unused]] const auto scope = trace.scope("stresses", i);
    const Stress sigma_max = k.sigma_max, sigma_SK = k.sigma_SK;
    STEP_TO(k, a_S, sigma_max * j_ges / sigma_SK, "static utilisation, [FKM] 1.6");
  }
  if (complete) r.u_S = combined("u_S", r, &FkmStress::a_S, false, trace);
}

/// Where its numbers were found: outside they say nothing.
template <class Tracer>
void fkm_ranges(const Din743Section& s, const FkmService& l, const FkmRoot& root, FkmSafety& r, Tracer& trace) {
  ranges(s, root.din743.t, r, trace);
  if (is_measured(s.notch)) {
    STEP_TO(r, x_small, 7.5 * mm / s.d,
            "the size factor of measured notches is given from 7.5 mm, [DIN743] part 2 (17)");
  }
  const double notched = is_set(r.x_G) ? r.x_G : 0.0;
  const double x_notch = trace.value("x_notch", notched, "steepest gradient of a notch over 100/mm");
  STEP(x_d, 2.0 / s.d * (0.01 * mm), "gradient over the diameter over 100/mm");
  STEP_TO(r, x_G, max(x_notch, x_d), "the support factor is given up to 100/mm, [FKM] 2.3");
  if (is_set(l.N)) {
    const double N = l.N;
    STEP_TO(r, x_N, 1e4 / N, "below 1e4 cycles lives are those of strains (limit set by loadpath)");
  }
}

template <class Tracer>
void fatigue_utilisation(const FkmService& l, FkmSafety& r, Tracer& trace) {
  r.u_D = combined("u_D", r, &FkmStress::a, true, trace);
  const double u_D = r.u_D, j_D = l.j_D;
  r.S_D = u_D != 0.0 ? NAMED_STEP("S_D", j_D / u_D, "factor on the amplitudes, as the load grows")
                     : trace.value("S_D", any_safety, "nothing varies");
}

/// The utilisations of one section. Its stresses are in a list "stresses" of the result, in order, only those that
/// act.
template <class Tracer>
FkmSafety fkm_section(const FkmSteel& steel, const Din743Section& s, const Din743Loads& loads, const FkmService& l,
                      Tracer& trace) {
  FkmSafety r;
  STEP_TO(r, d_eff, is_set(steel.d_h) ? steel.d_h : is_set(s.D) ? max(s.d, s.D) : s.d, "diameter at heat treatment");
  fkm_strengths(steel, r, trace);
  FkmRoot root;
  root.R_md = root.din743.sigma_Bd = r.R_md, root.din743.sigma_Sd = r.R_ed;
  depth(s, root.din743, trace);
  const auto kinds = acting(loads);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    [[maybe_unused]] const auto scope = trace.scope("stresses", i);
    r.stresses.push_back(stress_of_section(steel, s, loads, l, kinds[i], root, r, trace));
  }
  mean_stresses(steel, l, r, trace);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    [[maybe_unused]] const auto scope = trace.scope("stresses", i);
    hold_amplitude(l, kinds[i].kind, r.stresses[i], trace);
  }
  ductility(steel, s, r, trace);
  fatigue_utilisation(l, r, trace);
  static_utilisation(l, r, trace);
  fkm_ranges(s, l, root, r, trace);
  return r;
}

}  // namespace loadpath::fatigue
