// Constraints between inputs of DIN 743, for every calculator that rates sections by it.
#pragma once

#include "calculators/fatigue/din743/nominal.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"

#include <array>

namespace loadpath::fatigue {

template <class Input>
constexpr auto din743_steel_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) { return is_set(in.sigma_B) != is_set(in.R_m); }, "sigma_B, R_m",
                  "give the tensile strength: sigma_B at the reference diameter with its group, or R_m in this size "
                  "(or a material), not both"},
      Rule<Input>{
          [](const Input& in) { return is_set(in.sigma_B) == is_set(in.sigma_S) && is_set(in.R_m) == is_set(in.R_e); },
          "sigma_S, R_e, sigma_B, R_m", "give sigma_B with sigma_S, or R_m with R_e"},
      Rule<Input>{[](const Input& in) { return is_set(in.sigma_B) == (in.group != SteelGroup::none); },
                  "group, sigma_B", "sigma_B needs the group of steels, for K_1; R_m of this size needs none"},
      Rule<Input>{[](const Input& in) { return !(in.sigma_S > in.sigma_B || in.R_e > in.R_m); },
                  "sigma_S, R_e, sigma_B, R_m", "the yield strength must not exceed the tensile strength"},
      Rule<Input>{[](const Input& in) {
                    const Stress most = is_set(in.sigma_B) ? in.sigma_B : in.R_m;
                    return !(in.sigma_zdW >= most || in.sigma_bW >= most || in.tau_tW >= most);
                  },
                  "sigma_zdW, sigma_bW, tau_tW, sigma_B, R_m", "fatigue limit must be below the tensile strength R_m"}};
}

template <class Input>
constexpr auto din743_section_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) { return in.notch != Notch::untold; }, "notch",
                  "notch type missing; give notch = \"shoulder\", \"keyway\" ..., or \"smooth\""},
      Rule<Input>{[](const Input& in) { return !has_depth(in.notch) || in.D > in.d; }, "D, d, notch",
                  "a shoulder or a groove needs the larger diameter D > d"},
      Rule<Input>{[](const Input& in) { return !needs_radius(in.notch) || is_set(in.r); }, "r, notch",
                  "this notch needs its radius r"},
      Rule<Input>{[](const Input& in) { return in.notch != Notch::smooth || !is_set(in.r); }, "r, notch",
                  "a smooth section has no radius; for a shoulder give notch = \"shoulder\" with D"},
      Rule<Input>{[](const Input& in) { return in.notch != Notch::rectangular_groove || is_set(in.w); }, "w, notch",
                  "a rectangular groove needs its width w"},
      Rule<Input>{[](const Input& in) { return !needs_roughness(in.notch) || is_set(in.R_z); }, "R_z, notch",
                  "give the roughness R_z at the notch (only under a hub the notch factor includes it)"},
      Rule<Input>{[](const Input& in) { return in.notch != Notch::cross_hole || in.r < 0.29 * in.d; }, "r, d",
                  "the hole must be smaller than the section"},
      Rule<Input>{[](const Input& in) { return in.d_bore < in.d; }, "d_bore, d",
                  "the bore must be smaller than the outer diameter of the shaft"},
      Rule<Input>{[](const Input& in) { return !(in.d_h < in.d || in.d_h < in.D); }, "d_h, d, D",
                  "the heat treatment diameter must not be below that of the finished part"}};
}

/// Actions on a section, by the keys of SectionActions.
template <class Input>
Din743Loads acting_loads(const Input& in) {
  Din743Loads l;
  l.F_zd = {in.F_zdm, in.F_zda, in.F_zdmax};
  l.M_b = {in.M_bm, in.M_ba, in.M_bmax};
  l.M_t = {in.M_tm, in.M_ta, in.M_tmax};
  l.sigma_zd = {in.sigma_zdm, in.sigma_zda, in.sigma_zdmax};
  l.sigma_b = {in.sigma_bm, in.sigma_ba, in.sigma_bmax};
  l.tau_t = {in.tau_tm, in.tau_ta, in.tau_tmax};
  l.f_max = in.f_max;
  return l;
}

template <class Input>
Din743Loads din743_loads(const Input& in) {
  Din743Loads l = acting_loads(in);
  l.mean = in.mean, l.S_min = in.S_min;
  return l;
}

/// Whether a test is true for each acting load; absent actions are skipped.
template <class Test>
bool each_acting(const Din743Loads& l, const Test& test) {
  const auto passes = [&](const auto& action) { return !action.acts() || test(action); };
  return passes(l.F_zd) && passes(l.M_b) && passes(l.M_t) && passes(l.sigma_zd) && passes(l.sigma_b) && passes(l.tau_t);
}

/// Fatigue concerns varying loads: amplitudes are typed, 0 for a static load.
template <class Input>
Applies any_varies(const Input& in) {
  const auto stands = [](const auto& a) { return !(a.amplitude > 0.0 * a.amplitude.from_value(1.0)); };
  return where(!each_acting(acting_loads(in), stands));
}

/// Roundings of a sum that was typed must not refuse it.
template <class Quantity>
bool holds_its_cycle(const Din743Action<Quantity>& a) {
  return !(abs(a.largest) < (1.0 - 1e-9) * (abs(or_zero(a.mean)) + or_zero(a.amplitude)));
}

template <class Input>
bool has_typed_factors(const Input& in) {
  if (!is_typed(in.notch)) return true;
  const bool alpha = in.notch == Notch::alpha;
  for (const Din743Acting& a : acting(acting_loads(in))) {
    const double typed = alpha ? typed_of(a.kind, in.alpha_zd, in.alpha_b, in.alpha_t)
                               : typed_of(a.kind, in.beta_zd, in.beta_b, in.beta_t);
    if (!is_set(typed)) return false;
  }
  return true;
}

template <class Input>
constexpr auto din743_load_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) { return !acting(acting_loads(in)).empty(); },
                  "M_ba, F_zda, M_ta, sigma_ba, sigma_zda, tau_ta",
                  "give the loads: force or moments, or their nominal stresses"},
      Rule<Input>{[](const Input& in) {
                    const Din743Loads l = acting_loads(in);
                    return !(l.F_zd.acts() && l.sigma_zd.acts()) && !(l.M_b.acts() && l.sigma_b.acts()) &&
                           !(l.M_t.acts() && l.tau_t.acts());
                  },
                  "sigma_zdm, sigma_bm, tau_tm, F_zdm, M_bm, M_tm",
                  "give a load as force or moment, or as its nominal stress, not both"},
      Rule<Input>{[](const Input& in) {
                    return each_acting(acting_loads(in), [](const auto& a) { return is_set(a.amplitude); });
                  },
                  "F_zda, M_ba, M_ta, sigma_zda, sigma_ba, tau_ta",
                  "amplitude missing; give one for each mean or maximum load (0 if static)"},
      Rule<Input>{[](const Input& in) {
                    return each_acting(acting_loads(in), [](const auto& a) { return holds_its_cycle(a); });
                  },
                  "F_zdmax, M_bmax, M_tmax, sigma_zdmax, sigma_bmax, tau_tmax, F_zdm, M_bm, M_tm, sigma_zdm, sigma_bm, "
                  "tau_tm, F_zda, M_ba, M_ta, sigma_zda, sigma_ba, tau_ta",
                  "the maximum load must be at least mean plus amplitude"},
      Rule<Input>{&has_typed_factors<Input>, "alpha_zd, alpha_b, alpha_t, beta_zd, beta_b, beta_t, notch",
                  "give the factor of each acting stress: alpha_... or beta_..., by the notch type"}};
}

template <class Input>
constexpr auto din743_rules() {
  return join(din743_steel_rules<Input>(), din743_section_rules<Input>(), din743_load_rules<Input>());
}

}  // namespace loadpath::fatigue
