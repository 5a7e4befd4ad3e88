// Effect of a notch, its roughness and the stress gradient on a fatigue limit by [FKM]: K_f, K_R and the design
// factor K_WK of nominal stresses. Shape factors and gradients of shoulders, grooves and holes are those that DIN 743
// has as well; for measured notch factors the support of bending over the diameter is not counted, which is on the
// safe side. That both gradients are counted one after the other is recalled.
#pragma once

#include "calculators/fatigue/din743/notch.hpp"
#include "calculators/fatigue/fkm/material.hpp"

namespace loadpath::fatigue {

/// Common arguments of the functions for the section, and those of this stress.
struct FkmRoot {
  Din743Root din743;
  Stress R_md = unset<Stress>;
  double f_W = unset<double>;  // shear over normal
};

/// The support of a gradient of the stress, Stieler's as FKM has it.
template <class Tracer>
double fkm_support(const char* symbol, Twist gradient, FkmSteelGroup group, const FkmRoot& root, Tracer& trace) {
  using std::pow;
  const bool stainless = group == FkmSteelGroup::stainless;
  const double a_G = trace.value("a_G", stainless ? 0.40 : 0.50, "of steels, [FKM] 2.3");
  const Stress b_G = trace.value("b_G", stainless ? 2400.0 * MPa : 2700.0 * MPa, "of steels, [FKM] 2.3");
  const Twist G = trace.value("G", gradient, "gradient of the stress over the stress");
  const Stress R_md = root.R_md;
  const double f_W = root.f_W;
  STEP(e_G, a_G + f_W * R_md / b_G, "exponent, [FKM] 2.3");
  if (G * (1.0 * mm) <= 0.1)
    return NAMED_STEP(symbol, 1.0 + G * (1.0 * mm) * pow(10.0, 0.5 - e_G), "up to 0.1/mm, [FKM] 2.3");
  if (G * (1.0 * mm) <= 1.0)
    return NAMED_STEP(symbol, 1.0 + sqrt(G * (1.0 * mm)) * pow(10.0, -e_G), "0.1 to 1/mm, [FKM] 2.3");
  return NAMED_STEP(symbol, 1.0 + pow(G * (1.0 * mm), 0.25) * pow(10.0, -e_G), "1 to 100/mm, [FKM] 2.3");
}

inline Twist typed_gradient(const FkmService& l, Stressing kind) {
  return kind == Stressing::tension ? l.G_zd : kind == Stressing::bending ? l.G_b : l.G_t;
}

/// The stress concentration factor, and the gradient next to the notch if there is one.
template <class Tracer>
Twist fkm_shape(const Din743Section& s, const FkmService& l, const FkmRoot& root, Stressing kind, FkmStress& k,
                Tracer& trace) {
  if (s.notch == Notch::smooth) {
    k.K_t = trace.value("K_t", 1.0, "no notch");
    return unset<Twist>;
  }
  if (s.notch == Notch::alpha) {
    k.K_t = trace.value("K_t", typed_of(kind, s.alpha_zd, s.alpha_b, s.alpha_t), "as given");
    return typed_gradient(l, kind);
  }
  const double alpha =
      s.notch == Notch::cross_hole ? hole_factor(s, kind, trace) : shape_factor(s, kind, root.din743.t, trace);
  k.K_t = trace.value("K_t", alpha, "shape factor, [FKM] 5.2 as [DIN743] part 2 has it");
  return gradient(s, kind, root.din743.phi, trace);
}

/// The gradient over the diameter.
template <class Tracer>
double fkm_support_of_size(const Din743Section& s, FkmSteelGroup group, const FkmRoot& root, Stressing kind,
                           Tracer& trace) {
  if (kind == Stressing::tension) return trace.value("n_d", 1.0, "tension is uniform over the section");
  const Twist G_d = NAMED_STEP("G_d", 2.0 / s.d, "over the diameter, [FKM] 2.3");
  return fkm_support("n_d", G_d, group, root, trace);
}

/// K_t over the supports of both gradients; the steepest of the first is handed back.
template <class Tracer>
Twist fkm_by_shape(const Din743Section& s, FkmSteelGroup group, const FkmService& l, const FkmRoot& root,
                   Stressing kind, FkmStress& k, Tracer& trace) {
  const Twist steep = fkm_shape(s, l, root, kind, k, trace);
  const double K_t = k.K_t;
  if (is_set(steep)) {
    const double n_r = fkm_support("n_r", steep, group, root, trace);
    k.n = NAMED_STEP("n", min(n_r, K_t), "a notch does not strengthen");
  } else {
    k.n = trace.value("n", 1.0, "no gradient of a notch");
  }
  k.n_d = fkm_support_of_size(s, group, root, kind, trace);
  const double n = k.n, n_d = k.n_d;
  STEP_TO(k, K_f, K_t / (n * n_d), "notch factor, [FKM] 2.3; that both supports count is not checked");
  return steep;
}

template <class Tracer>
double fkm_roughness(const char* symbol, Length R_z, const FkmRoot& root, Tracer& trace) {
  const double f_W = root.f_W;
  const double lg_R = trace.value("lg_R", std::log10(std::clamp(R_z / um, 1.0, 200.0)), "lg of R_z, 0 below 1 um");
  const double lg_S =
      trace.value("lg_S", std::max(std::log10(root.R_md / (200.0 * MPa)), 0.0), "lg of 2 R_m/400 MPa, [FKM] 2.3");
  return NAMED_STEP(symbol, 1.0 - f_W * 0.22 * lg_R * lg_S, "roughness of steels, [FKM] 2.3");
}

template <class Tracer>
void fkm_surface(const Din743Section& s, const FkmRoot& root, FkmStress& k, Tracer& trace) {
  if (!needs_roughness(s.notch)) {
    k.K_R = trace.value("K_R", 1.0, "within the notch factor");
    return;
  }
  const Length of_bars = is_groove(s.notch) ? 20.0 * um.one : s.R_zB;
  if (!is_set(of_bars)) {
    k.K_R = fkm_roughness("K_R", s.R_z, root, trace);
    return;
  }
  const double K_RP = fkm_roughness("K_RP", s.R_z, root, trace);
  const double K_RB = fkm_roughness("K_RB", of_bars, root, trace);
  STEP_TO(k, K_R, K_RP / K_RB, "rougher than the bars of the tests");
}

/// Whether the notch factor is that of tests.
constexpr bool is_measured(Notch n) { return n == Notch::beta || is_keyed(n) || n == Notch::press_fit || is_groove(n); }

/// The design factor of nominal stresses; the gradient next to the notch is returned, unset if not given.
template <class Tracer>
Twist fkm_design_factor(const Din743Section& s, FkmSteelGroup group, const FkmService& l, const FkmRoot& root,
                        Stressing kind, FkmStress& k, Tracer& trace) {
  Twist steep = unset<Twist>;
  if (is_measured(s.notch)) {
    Din743Stress measured;
    trace.value("sigma_Bd", root.din743.sigma_Bd, "R_md, which the tests belong to");
    trace.value("sigma_Sd", root.din743.sigma_Sd, "R_ed, which the tests belong to");
    by_tests(s, root.din743, kind, measured, trace);
    k.K_f = trace.value("K_f", measured.beta, "beta from tests: no support factor in bending in addition");
  } else {
    steep = fkm_by_shape(s, group, l, root, kind, k, trace);
  }
  fkm_surface(s, root, k, trace);
  const double K_f = k.K_f, K_R = k.K_R;
  STEP_TO(k, K_WK, (K_f + 1.0 / K_R - 1.0) / s.K_V, "design factor of nominal stresses, [FKM] 2.3");
  return steep;
}

}  // namespace loadpath::fatigue
