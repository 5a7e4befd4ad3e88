// The size that the strength of a quenched and tempered steel belongs to: that of the part when it was heat treated. A
// bar of 50 mm that is turned to 40 mm has the strength of 50 mm.
#pragma once

#include "lib/calculator/field.hpp"

namespace loadpath {

template <class Input>
constexpr auto diameter_at_heat_treatment(Length Input::*at) {
  return Field<Input, Length>{at, "d_h", mm, "heat treatment diameter, basis of the material strength"}
      .positive()
      .usually(1, 2000)
      .may_be_missing();
}

template <class Input>
constexpr Rule<Input> heat_treated_before_turning() {
  return {[](const Input& in) { return !(in.d_h < in.d); }, "d_h, d",
          "the heat treatment diameter must not be below that of the finished part"};
}

}  // namespace loadpath
