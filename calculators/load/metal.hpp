// Recognition of metals without fatigue limit: by the modulus of elasticity and density from the row of a material.
// For irons and steels the curve becomes level; aluminium, copper, magnesium, titanium and zinc fail at any stress
// with enough cycles, [B20]: they are assessed at a number of cycles, or not at all.
#pragma once

#include "calculators/load/steel.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/quantity/drive_units.hpp"

namespace loadpath {

template <class Input>
constexpr auto density_of_material(Density Input::*at) {
  return Field<Input, Density>{at, "rho", kg_per_m3, "density, identifies iron or steel together with the modulus"}
      .positive()
      .usually(500, 20000)
      .from("material", "rho")
      .where_it_has();
}

/// Whether it is neither iron nor steel; false if unknown. Grey iron has from some 78 GPa and 6.9 g/cm3 on, steels up
/// to some 235 GPa and 8.2 g/cm3; aluminium bronzes are as dense as steels, with the modulus of irons.
inline bool lacks_fatigue_limit(Stress E, Density rho) {
  const bool odd_modulus = E < 75.0 * GPa || E > 240.0 * GPa;
  const bool odd_density = rho < 6800.0 * kg_per_m3 || rho > 8250.0 * kg_per_m3;
  return odd_modulus || odd_density || (rho > 7450.0 * kg_per_m3 && E < 160.0 * GPa);
}
template <class Input>
bool lacks_fatigue_limit(const Input& in) {
  return lacks_fatigue_limit(in.E, in.rho);
}

/// The cycles that a part of such a metal must last, and those that its fatigue strength was measured at.
template <class Input>
constexpr auto cycles_of_metal() {
  return Fields{Field<Input, double>{&Input::N, "N", ratio, "required life in cycles (metal without fatigue limit)"}
                    .at_least(1)
                    .may_be_missing(),
                Field<Input, double>{&Input::N_D, "N_D", ratio,
                                     "cycles at which sigma_D was determined (metal without fatigue limit)"}
                    .within(1e4, 1e10)
                    .may_be_missing()};
}
template <class Result>
constexpr auto cycles_over_told(double Result::*at) {
  return Field<Result, double>{at, "x_N", ratio,
                               "metal without fatigue limit: required cycles / cycles of the fatigue limit"}
      .limit(0, 1 + 1e-9)
      .where_it_applies();
}
template <class Input, class Result, class Tracer>
void compare_cycles(const Input& in, Result& r, Tracer& trace) {
  if (!lacks_fatigue_limit(in) || !is_set(in.N) || !is_set(in.N_D)) return;
  STEP_TO(r, x_N, in.N / in.N_D, "no iron or steel: the strength beyond is not known, [B20]");
}
/// `varies`: whether the load does.
template <auto varies, class Input>
constexpr Mode<Input> fatigue_of_metal() {
  return Mode<Input>{
      "cycles", "fatigue without a fatigue limit (N and N_D, or fatigue.life)",
      [](const Input& in) { return where(lacks_fatigue_limit(in) && varies(in) > decltype(varies(in)){}); }}
      .judged_by("x_N")
      .wanting("N, N_D");
}

/// The given group must be true of the metal. For steels the modulus is compared with theirs.
template <class Input>
constexpr Rule<Input> group_of_metal() {
  return {[](const Input& in) {
            using Group = decltype(in.group);
            const bool iron = in.group >= Group::grey_iron && in.group < Group::wrought_aluminium;
            return !(iron && lacks_fatigue_limit(in));
          },
          "group, material", "modulus and density are not those of iron or steel: give the group of the material"};
}

}  // namespace loadpath
