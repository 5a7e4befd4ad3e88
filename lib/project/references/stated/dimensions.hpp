// What values of [values] are compared by: their dimensions, and how near they count as equal.
#pragma once

#include "lib/quantity/dimension.hpp"

namespace loadpath::project::stated {

inline constexpr double in_few_digits = 1e-3;  // of values with few digits
inline constexpr double rounded = 0.02;        // of values that are rounded elsewhere

inline const Dimension length = Dimension::of(1, 0, 0);
inline const Dimension mass = Dimension::of(0, 1, 0);
inline const Dimension density = Dimension::of(-3, 1, 0);
inline const Dimension inertia = Dimension::of(2, 1, 0);
inline const Dimension force = Dimension::of(1, 1, -2);
inline const Dimension torque = Dimension::of(2, 1, -2);
inline const Dimension power = Dimension::of(2, 1, -3);
inline const Dimension pressure = Dimension::of(-1, 1, -2);
inline const Dimension duration = Dimension::of(0, 0, 1);
inline const Dimension speed = Dimension::of(1, 0, -1);
inline const Dimension rate = Dimension::of(0, 0, -1);
inline const Dimension heat = [] {
  Dimension dimension;
  dimension.twelfths[Dimension::temperature] = Dimension::one;
  return dimension;
}();

}  // namespace loadpath::project::stated
