// Deflection of the shafts under the teeth: by the position of the pinion, method C, or as the elastic lines of both
// shafts have it, in shaft.design.
#pragma once

#include "calculators/gear/rating/choices.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/fit_units.hpp"

#include <array>

namespace loadpath::gear {

/// Whether f_sh of the shafts is given.
template <class Input>
bool has_deflections(const Input& in) {
  return is_set(in.f_sh_1);
}

template <class Input>
bool is_away_from_middle(const Input& in) {
  return in.place > Place::middle;
}

/// Whether any input of method C is given.
template <class Input>
bool has_position(const Input& in) {
  return in.place != Place::untold || is_set(in.l) || is_set(in.s) || is_set(in.d_sh) ||
         in.stiffening != Stiffening::none;
}

template <class Input>
constexpr auto deflection_inputs() {
  return Fields{
      Field{&Input::f_sh_1, "f_sh_1", um,
            "misalignment of the teeth from the deflection of shaft 1, K_A included; replaces place, l, s and d_sh: "
            "f_sh_1 = \"=shaft.seats.pinion.f_sh\""}
          .at_least(0)
          .usually(0, 200)
          .may_be_missing(),
      Field{&Input::f_sh_2, "f_sh_2", um, "misalignment from the deflection of shaft 2, K_A included; omitted: rigid"}
          .at_least(0)
          .usually(0, 200)
          .may_be_missing()};
}

template <class Input>
constexpr auto position_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) {
                    return !is_away_from_middle(in) || has_deflections(in) ||
                           (is_set(in.l) && is_set(in.d_sh) && is_set(in.s));
                  },
                  "place, l, d_sh, s", "a pinion away from the middle needs l, s and d_sh"},
      Rule<Input>{[](const Input& in) { return is_away_from_middle(in) || has_deflections(in) || !is_set(in.s); },
                  "place, s", "midway between the bearings s is zero: for another position name a to e"}};
}

/// Of the shafts in place of a position.
template <class Input>
constexpr auto deflection_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) { return in.place != Place::untold || has_deflections(in); }, "place, f_sh_1",
                  "give the position of the pinion relative to the bearings: place = \"middle\", or \"a\" to \"e\"; or "
                  "the deflection of its shaft: f_sh_1 = \"=shaft.seats.pinion.f_sh\""},
      Rule<Input>{
          [](const Input& in) { return !has_deflections(in) || !has_position(in); },
          "f_sh_1, place, l, s, d_sh, stiffening",
          "f_sh_1, from the elastic line of the shaft, replaces the formula of method C: omit either f_sh_1, or "
          "place, l, s, d_sh and stiffening"},
      Rule<Input>{[](const Input& in) { return has_deflections(in) || !is_set(in.f_sh_2); }, "f_sh_1, f_sh_2",
                  "f_sh_2 is added to the deflection of the pinion shaft: give f_sh_1"}};
}

/// The misalignment of both shafts under F_t K_A.
template <class Input, class Tracer>
Length deflection_of_shafts(const Input& in, Tracer& trace) {
  if (!is_set(in.f_sh_2)) return NAMED_STEP("f_shA", in.f_sh_1, "of shaft 1, K_A included; shaft 2 as rigid");
  return NAMED_STEP("f_shA", in.f_sh_1 + in.f_sh_2,
                    "of both shafts, K_A included; magnitudes added, on the safe side if they compensate");
}

}  // namespace loadpath::gear
