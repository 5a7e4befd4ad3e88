// The functions of angles that the formulas of gears use: in this folder they take precedence over those of the C
// library, so that a sweep of pairs goes through wide registers and gives what a single run gives.
#pragma once

#include "calculators/gear/trigonometry.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::gear {

[[nodiscard]] inline double sin(double angle) { return numerics::sine(angle); }
[[nodiscard]] inline double cos(double angle) { return numerics::cosine(angle); }
[[nodiscard]] inline double tan(double angle) { return numerics::tangent(angle); }
[[nodiscard]] inline double atan(double x) { return numerics::arc_tangent(x); }
[[nodiscard]] inline double acos(double x) { return numerics::arc_cosine(x); }
[[nodiscard]] inline double atan(const Ratio& x) { return numerics::arc_tangent(x.value()); }
[[nodiscard]] inline double acos(const Ratio& x) { return numerics::arc_cosine(x.value()); }

}  // namespace loadpath::gear
