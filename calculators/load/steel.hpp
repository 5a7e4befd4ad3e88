// Recognition of steels, for formulas only for steels: by the modulus of elasticity from the row of a material. That
// of irons, aluminium, bronzes and titanium lies outside.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath {

template <class Input>
constexpr auto modulus_of_material(Stress Input::*at) {
  return Field<Input, Stress>{at, "E", GPa, "modulus of elasticity (identifies steel)"}
      .positive()
      .usually(least_E, most_E)
      .from("material", "E")
      .where_it_has();
}

template <class Result>
constexpr auto modulus_over_steel(double Result::*at) {
  return Field<Result, double>{at, "x_E", ratio, "modulus of elasticity / 210 GPa (steel)"}
      .limit(0.85, 1.1)
      .where_it_applies();
}

/// Where it is known whose formulas they are; `why` says of what.
template <class Result, class Tracer>
void compare_with_steel(Stress E, Result& r, const char* why, Tracer& trace) {
  if (!is_set(E)) return;
  STEP_TO(r, x_E, E / (210.0 * GPa), why);
}

}  // namespace loadpath
