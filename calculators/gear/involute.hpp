// The involute function and its inverse.
#pragma once

#include "calculators/gear/trigonometry.hpp"
#include "lib/numerics/cube_root.hpp"

#include <limits>

namespace loadpath::gear {

/// tan(alpha) - alpha, the polar angle of an involute at the pressure angle alpha, rad.
[[nodiscard]] inline double involute(double alpha) { return numerics::tangent(alpha) - alpha; }

/// The pressure angle, rad, whose involute function is the given one; NaN unless that is > 0.
/// Newton's method for t = tan(alpha): t - atan(t) = inv is convex for t > 0, so from above it never overshoots. It
/// starts above the root, less than a fifth of it away: t^3/3 and t bound t - atan(t) from its two ends.
[[nodiscard]] inline double angle_of_involute(double inv) {
  double t = numerics::cube_root(3.0 * inv) + inv;
  const auto refine = [&] { t -= (t - numerics::arc_tangent(t) - inv) * (1.0 + t * t) / (t * t); };
  refine(), refine(), refine(), refine(), refine();
  const bool exists = inv > 0.0 && inv <= std::numeric_limits<double>::max();
  return exists ? numerics::arc_tangent(t) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace loadpath::gear
