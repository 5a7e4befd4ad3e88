// Part 1 of DIN 743: from the nominal stresses of a section to its safeties against fatigue and against yielding.
//
// din743(steel, section, loads, trace) rates one section. Tension is positive. In bending and torsion the sign has no
// effect: a round section has a fibre of each sign. The magnitude of compression is checked against yielding as well,
// which the standard leaves to the static proof.
#pragma once

#include "calculators/fatigue/din743/material.hpp"
#include "calculators/fatigue/din743/nominal.hpp"
#include "calculators/fatigue/din743/notch.hpp"

#include <algorithm>
#include <limits>

namespace loadpath::fatigue {

/// K_F of the section, and of the bars that a measured notch factor is of.
template <class Tracer>
void roughness(const Din743Section& s, Din743Root& root, Tracer& trace) {
  if (!needs_roughness(s.notch)) {
    root.K_F = trace.value("K_F", 1.0, "within the notch factor, [DIN743] part 2 table 1");
    return;
  }
  root.K_F = roughness_factor("K_F", root.sigma_Bd, s.R_z, "roughness, [DIN743] part 2 (18)", trace);
  const Length of_bars = is_groove(s.notch) ? 20.0 * um.one : s.R_zB;
  if (is_set(of_bars))
    root.K_FB = roughness_factor("K_FB", root.sigma_Bd, of_bars, "roughness of the bars of the tests", trace);
}

template <class Tracer>
double surface_of(const Din743Root& root, Stressing kind, Tracer& trace) {
  const double K_F = root.K_F, K_FB = root.K_FB;
  const bool torsion = kind == Stressing::torsion;
  if (is_set(K_FB))
    return torsion ? NAMED_STEP("K_R", (0.575 * K_F + 0.425) / (0.575 * K_FB + 0.425),
                                "rougher than the bars of the tests, [DIN743] part 2 (19), (21)")
                   : NAMED_STEP("K_R", K_F / K_FB, "rougher than the bars of the tests, [DIN743] part 2 (20)");
  return torsion && K_F != 1.0 ? NAMED_STEP("K_R", 0.575 * K_F + 0.425, "torsion, [DIN743] part 2 (19)")
                               : NAMED_STEP("K_R", K_F, "roughness, [DIN743] part 2 (18)");
}

template <class Tracer>
double geometric_size(Length d, Stressing kind, Tracer& trace) {
  if (kind == Stressing::tension) return trace.value("K_2", 1.0, "tension, [DIN743] part 2 (15)");
  return size_factor("K_2", d, "size in bending and torsion, [DIN743] part 2 (16)", trace).K;
}

/// The fatigue limit of the section in symmetric cycles, and how much a mean stress takes off it.
template <class Tracer>
void limit_in_symmetric_cycles(const Din743Steel& steel, const Din743Section& s, const Din743Root& root,
                               const Din743Safety& r, Stressing kind, Din743Stress& k, Tracer& trace) {
  notch_factor(s, root, kind, k, trace);
  k.K_2 = geometric_size(s.d, kind, trace);
  k.K_R = surface_of(root, kind, trace);
  const double beta = k.beta, K_2 = k.K_2, K_R = k.K_R;
  STEP_TO(k, K_sigma, (beta / K_2 + 1.0 / K_R - 1.0) / s.K_V, "total influence, [DIN743] part 1 (8), (9)");
  const Stress sigma_W = smooth_limit(steel, kind, r, trace), sigma_Bd = r.sigma_Bd;
  STEP_TO(k, sigma_WK, sigma_W / K_sigma, "of the section, r = −1, [DIN743] part 1 (5) to (7)");
  STEP_TO(k, psi, sigma_WK / (2.0 * sigma_Bd - sigma_WK), "sensitivity to mean stress, [DIN743] part 1 (20) to (22)");
}

/// At the root of a notch that runs around, by its factor.
inline double raised_yield(double factor) {
  return factor < 1.5 ? 1.0 : factor < 2.0 ? 1.05 : factor < 3.0 ? 1.1 : 1.15;
}

inline double supporting(const Din743Section& s, Stressing kind) {
  if (kind == Stressing::tension || s.layer == Layer::hard) return 1.0;
  const bool hollow = s.d_bore > 0.0 * m.one;
  return !hollow ? 1.2 : kind == Stressing::bending ? 1.1 : 1.0;
}

template <class Tracer>
void yield_limit(const Din743Section& s, Stress strength, Stressing kind, Din743Stress& k, Tracer& trace) {
  const Stress sigma_Sd = strength;
  const double K_2F = trace.value("K_2F", supporting(s, kind), "support of the section, [DIN743] part 1 table 3");
  if (kind == Stressing::torsion) {
    STEP_TO(k, sigma_FK, K_2F * sigma_Sd / sqrt(3.0), "yield limit in torsion, [DIN743] part 1 (32)");
    return;
  }
  const bool raised = runs_around(s.notch) && s.layer == Layer::none;
  const double gamma_F = trace.value("gamma_F", raised ? raised_yield(is_set(k.alpha) ? k.alpha : k.beta) : 1.0,
                                     "by alpha of a notch that runs around, or beta, [DIN743] part 1 table 2");
  STEP_TO(k, sigma_FK, K_2F * gamma_F * sigma_Sd, "yield limit of the section, [DIN743] part 1 (31)");
}

/// Amplitude over its limit.
template <class Tracer>
void hold_amplitude(Din743Stress& k, Stress mean_v, MeanStress mean, Tracer& trace) {
  k.sigma_mv = trace.value("sigma_mv", mean_v, "equivalent mean stress, in torsion that of shear");
  if (!(k.sigma_a > 0.0 * MPa)) {
    k.u_a = trace.value("u_a", 0.0, "this stress does not vary");
    return;
  }
  const Stress sigma_mv = k.sigma_mv, sigma_WK = k.sigma_WK, sigma_FK = k.sigma_FK, sigma_a = k.sigma_a;
  const double psi = k.psi;
  k.sigma_ADK =
      mean == MeanStress::constant
          ? NAMED_STEP("sigma_ADK", max(min(sigma_WK - psi * sigma_mv, sigma_FK - abs(sigma_mv)), 0.0 * MPa),
                       "the mean stress stays, [DIN743] part 1 (10) to (14)")
          : NAMED_STEP("sigma_ADK",
                       sigma_a / max((sigma_a + psi * sigma_mv) / sigma_WK, (sigma_a + abs(sigma_mv)) / sigma_FK),
                       "the ratio stays, [DIN743] part 1 (15) to (19)");
  const Stress sigma_ADK = k.sigma_ADK;
  STEP_TO(k, u_a, sigma_a / sigma_ADK, "part of the limit that the amplitude takes");
}

template <class Safety>
const auto* find_stress(const Safety& r, const Name& name) {
  for (const auto& k : r.stresses) {
    if (k.name == name) return &k;
  }
  return static_cast<decltype(r.stresses.data())>(nullptr);
}
template <class Safety, class Stresses, class Quantity>
Quantity of_stress(const Safety& r, const Name& name, Quantity Stresses::*at, Quantity none) {
  const auto* const k = find_stress(r, name);
  return k == nullptr ? none : k->*at;
}

/// The mean stresses as one, by von Mises. Compression that outweighs torsion makes it negative.
template <class Safety, class Stresses, class Tracer>
Stress mean_as_one(const Safety& r, Stress Stresses::*at, const char* why, Tracer& trace) {
  const Stress none = 0.0 * MPa;
  const Stress sigma_zdm = trace.value("sigma_zdm", of_stress(r, "tension", at, none), "mean of tension");
  const Stress sigma_bm = trace.value("sigma_bm", of_stress(r, "bending", at, none), "mean of bending");
  const Stress tau_tm = trace.value("tau_tm", of_stress(r, "torsion", at, none), "mean of torsion");
  STEP(sigma_n, sigma_zdm + sigma_bm, "on the tension side of bending");
  if (sigma_n >= none) return NAMED_STEP("sigma_mv", sqrt(pow<2>(sigma_n) + 3.0 * pow<2>(tau_tm)), why);
  if (3.0 * pow<2>(tau_tm) >= pow<2>(sigma_n))  // torsion outweighs the simultaneous compression
    return NAMED_STEP("sigma_mv", sqrt(3.0 * pow<2>(tau_tm) - pow<2>(sigma_n)), why);
  return NAMED_STEP("sigma_mv", -sqrt(pow<2>(sigma_n) - 3.0 * pow<2>(tau_tm)), why);
}

template <class Tracer>
void equivalent_mean(Din743Safety& r, Tracer& trace) {
  r.sigma_mv = mean_as_one(r, &Din743Stress::sigma_m, "of both signs, [DIN743] part 1 (23)", trace);
  const Stress sigma_mv = r.sigma_mv;
  STEP_TO(r, tau_mv, max(sigma_mv, 0.0 * MPa) / sqrt(3.0), "none where it presses, [DIN743] part 1 (24)");
}

/// Tension and bending of one sign add up, then torsion by squares.
template <class Safety, class Stresses, class Tracer>
double together(const char* symbol, const Safety& r, double Stresses::*at, const char* why, Tracer& trace) {
  const double v_zd = trace.value("v_zd", of_stress(r, "tension", at, 0.0), "of tension");
  const double v_b = trace.value("v_b", of_stress(r, "bending", at, 0.0), "of bending");
  const double v_t = trace.value("v_t", of_stress(r, "torsion", at, 0.0), "of torsion");
  return NAMED_STEP(symbol, sqrt(pow<2>(v_zd + v_b) + pow<2>(v_t)), why);
}

/// Where nothing is taken of a limit any safety is there.
inline constexpr double any_safety = std::numeric_limits<double>::infinity();

template <class Tracer>
void safeties(const Din743Loads& loads, Din743Safety& r, Tracer& trace) {
  const double S_min = loads.S_min;
  const char* const in_phase = "in phase: the standard takes them together, [DIN743] part 1 sections 4.1, 5.1";
  const double v_D = together("v_D", r, &Din743Stress::u_a, in_phase, trace);
  r.S_D = v_D != 0.0 ? NAMED_STEP("S_D", 1.0 / v_D, "safety against fatigue, [DIN743] part 1 section 4.1")
                     : trace.value("S_D", any_safety, "nothing varies");
  STEP_TO(r, u_D, S_min * v_D, "required / actual safety factor");
  const bool complete =
      std::all_of(r.stresses.begin(), r.stresses.end(), [](const auto& k) { return is_set(k.u_max); });
  if (!complete || r.stresses.empty()) return;
  const double v_F = together("v_F", r, &Din743Stress::u_max, in_phase, trace);
  r.S_F = v_F != 0.0 ? NAMED_STEP("S_F", 1.0 / v_F, "safety against yielding, [DIN743] part 1 section 5.1")
                     : trace.value("S_F", any_safety, "nothing acts");
  STEP_TO(r, u_F, S_min * v_F, "required / actual safety factor");
}

inline double shape_of(const Din743Stress& k) { return k.alpha; }

/// Where the notch factors of the standard were found: outside they say nothing.
template <class Safety, class Tracer>
void ranges(const Din743Section& s, Length depth, Safety& r, Tracer& trace) {
  const Length t = depth;
  if (!is_typed(s.notch) && s.notch != Notch::smooth) {
    STEP_TO(r, x_bore, s.d_bore / s.d, "notch factors are those of solid shafts: type alpha or beta of a hollow one");
  }
  if (needs_roughness(s.notch)) {
    STEP_TO(r, x_Rz, s.R_z / (0.2 * mm), "rougher than a rolled skin (limit set by loadpath)");
  }
  if (has_shape_factors(s.notch)) {
    STEP_TO(r, x_r, 0.03 * t / s.r, "r/t from 0.03, [DIN743] part 2 tables 2, 3");
    STEP_TO(r, x_D, s.d / (0.98 * s.D), "d/D up to 0.98, [DIN743] part 2 tables 2, 3");
  }
  if (s.notch == Notch::v_groove) {
    STEP_TO(r, x_t, t / s.d, "0.05 to 0.2, [DIN743] part 2 section 4.2.3");
  }
  if (s.notch == Notch::cross_hole) {
    STEP_TO(r, x_hole, 2.0 * s.r / s.d,
            "up to 0.3: section modulus reduced by a strip at the hole, limit set by loadpath");
  }
  double largest = 0.0;
  for (const auto& k : r.stresses) largest = is_set(shape_of(k)) ? std::max(largest, shape_of(k)) : largest;
  if (largest == 0.0) return;
  const double alpha_max = trace.value("alpha_max", largest, "maximum shape factor");
  STEP_TO(r, x_alpha, alpha_max / 6.0, "alpha up to 6, [DIN743] part 2 tables 2, 3");
}

/// Mean stresses beyond the yield limit leave nothing to vary.
template <class Tracer>
void hold_mean(Din743Safety& r, Tracer& trace) {
  double most = unset<double>;
  for (const Din743Stress& k : r.stresses) {
    const double x = k.sigma_a > 0.0 * MPa ? static_cast<double>(abs(k.sigma_mv) / k.sigma_FK) : unset<double>;
    if (is_set(x) && !(x <= most)) most = x;
  }
  r.x_m = is_set(most) ? trace.value("x_m", most, "maximum sigma_mv/sigma_FK of the alternating stresses")
                       : trace.value("x_m", 0.0, "no alternating stress");
}

/// Depth of the notch, and whether it is shallow.
template <class Tracer>
void depth(const Din743Section& s, Din743Root& root, Tracer& trace) {
  if (!has_depth(s.notch)) return;
  root.t = NAMED_STEP("t", (s.D - s.d) / 2.0, "depth of the notch");
  const Length t = root.t;
  if (has_shape_factors(s.notch))
    root.phi = NAMED_STEP("phi", s.d / s.D > 0.67 ? 1.0 / (4.0 * sqrt(t / s.r) + 2.0) : 0.0,
                          "a shallow notch, [DIN743] part 2 tables 2, 3");
}

/// Notch root data independent of the kind of stress.
template <class Tracer>
Din743Root root_of(const Din743Section& s, const Din743Safety& r, Tracer& trace) {
  Din743Root root;
  root.sigma_Bd = r.sigma_Bd, root.sigma_Sd = r.sigma_Sd;
  roughness(s, root, trace);
  depth(s, root, trace);
  return root;
}

/// The safety factors of one section. Its stresses are in a list "stresses" of the result, one after the other.
template <class Tracer>
Din743Safety din743(const Din743Steel& steel, const Din743Section& s, const Din743Loads& loads, Tracer& trace) {
  Din743Safety r;
  STEP(d_eff, is_set(steel.d_h) ? steel.d_h : is_set(s.D) ? max(s.d, s.D) : s.d, "diameter at heat treatment");
  strengths(steel, d_eff, r, trace);
  const Din743Root root = root_of(s, r, trace);
  const auto kinds = acting(loads);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    [[maybe_unused]] const auto scope = trace.scope("stresses", i);
    Din743Stress k;
    k.name = kinds[i].name;
    nominal_stresses(s, loads, kinds[i].kind, k, trace);
    limit_in_symmetric_cycles(steel, s, root, r, kinds[i].kind, k, trace);
    yield_limit(s, r.sigma_Sd, kinds[i].kind, k, trace);
    r.stresses.push_back(k);
  }
  equivalent_mean(r, trace);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    [[maybe_unused]] const auto scope = trace.scope("stresses", i);
    Din743Stress& k = r.stresses[i];
    hold_amplitude(k, kinds[i].kind == Stressing::torsion ? r.tau_mv : r.sigma_mv, loads.mean, trace);
    if (!is_set(k.sigma_max)) continue;
    const Stress sigma_max = k.sigma_max, sigma_FK = k.sigma_FK;
    STEP_TO(k, u_max, sigma_max / sigma_FK, "maximum stress / yield limit");
  }
  safeties(loads, r, trace);
  hold_mean(r, trace);
  STEP_TO(r, x_small, 7.5 * mm / s.d, "K_2 and K_3 are given from 7.5 mm, [DIN743] part 2 (16), (17)");
  ranges(s, root.t, r, trace);
  return r;
}

}  // namespace loadpath::fatigue
