// The allowable shear stress of a part in torsion, from what is given of its material: itself, the allowable normal
// stress [B19], or the yield strength with a safety.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath {

enum class Behaviour { unsaid, ductile, brittle };

constexpr auto choices_of(Behaviour) {
  return std::array{
      ChoiceName<Behaviour>{Behaviour::unsaid, "", "not given"},
      ChoiceName<Behaviour>{Behaviour::ductile, "ductile", "ductile: 0.6 of the normal stress in shear"},
      ChoiceName<Behaviour>{Behaviour::brittle, "brittle", "brittle: 0.75 of the normal stress in shear"}};
}

struct ShearStrength {
  Stress tau_adm = unset<Stress>, sigma_adm = unset<Stress>;
  Behaviour behaviour = Behaviour::unsaid;
  Stress R_e = unset<Stress>;
  double S = unset<double>;
};

/// The fields of an input that derives from ShearStrength. `size`: the result that the strength of a material depends
/// on.
template <class Input>
constexpr auto shear_strength_inputs(const char* size) {
  Stress Input::*const tau_adm = &ShearStrength::tau_adm;
  Stress Input::*const sigma_adm = &ShearStrength::sigma_adm;
  Behaviour Input::*const behaviour = &ShearStrength::behaviour;
  Stress Input::*const R_e = &ShearStrength::R_e;
  double Input::*const S = &ShearStrength::S;
  return Fields{
      Field{tau_adm, "tau_adm", MPa, "allowable shear stress, without a further safety factor"}
          .positive()
          .usually(1, 1000)
          .customarily_at_most(600)
          .may_be_missing(),
      Field{sigma_adm, "sigma_adm", MPa, "allowable normal stress, replaces tau_adm (with behaviour)"}
          .positive()
          .usually(1, 1500)
          .customarily_at_most(900)
          .may_be_missing(),
      Choice{behaviour, "behaviour", "material behaviour, sets the ratio tau_adm / sigma_adm"}.may_be_missing(),
      Field{R_e, "R_e", MPa, "yield strength, with S in place of tau_adm"}
          .positive()
          .usually(50, 2500)
          .customarily_at_most(most_yield_strength)
          .from("material", "R_e", size, "tau_adm"),
      Field{S, "S", ratio, "safety factor against yielding, with R_e"}
          .at_least(1)
          .usually(1, 6)
          .customarily_at_least(1.2)
          .may_be_missing()
          .factor()};
}

/// Fields with bounds from a material.
inline constexpr Meaning all_in_shear{"tau_adm", allowable_in_shear}, all_in_normal{"sigma_adm", allowable_in_normal};

/// Exactly one complete definition of the strength; none if every part has its own.
inline bool one_shear_strength(const ShearStrength& in, bool all_have_their_own) {
  const bool by_sigma = is_set(in.sigma_adm), by_yield = is_set(in.S);
  const int ways = (is_set(in.tau_adm) ? 1 : 0) + (by_sigma ? 1 : 0) + (by_yield ? 1 : 0);
  const bool whole = by_sigma == (in.behaviour != Behaviour::unsaid) && (!by_yield || is_set(in.R_e));
  return whole && (ways == 1 || (ways == 0 && all_have_their_own));
}

/// Strength of a part with its own allowable stress, or with the common one.
template <class Tracer>
Stress allowable_shear(const ShearStrength& in, Stress own, Tracer& trace) {
  if (is_set(own)) return trace.value("tau_all", own, "its own, as given");
  if (is_set(in.tau_adm)) return NAMED_STEP("tau_all", in.tau_adm, "as given");
  if (is_set(in.S))
    return NAMED_STEP("tau_all", in.R_e / (sqrt(3.0) * in.S),
                      "yielding in shear by the distortion-energy theory, [Mises]");
  if (!is_set(in.sigma_adm)) return unset<Stress>;  // stiffness only
  if (in.behaviour == Behaviour::brittle) return NAMED_STEP("tau_all", 0.75 * in.sigma_adm, "brittle material, [B19]");
  return NAMED_STEP("tau_all", 0.6 * in.sigma_adm, "ductile material, [B19]");
}

/// The larger of two utilisations; unset where one of them is: what has no strength is not judged by the others.
inline double larger_use(double a, double b) { return is_set(a) && !(b <= a) ? b : a; }

}  // namespace loadpath
