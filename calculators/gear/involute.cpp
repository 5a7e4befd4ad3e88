#include "calculators/gear/involute.hpp"

#include <cmath>
#include <limits>

namespace loadpath::gear {

double involute(double alpha) { return std::tan(alpha) - alpha; }

/// Newton's method for t = tan(alpha): t - atan(t) = inv is convex for t > 0, so from above it never overshoots.
double angle_of_involute(double inv) {
  if (!(inv > 0.0) || std::isinf(inv)) return std::numeric_limits<double>::quiet_NaN();
  double t = std::cbrt(3.0 * inv) + inv;  // above the root: t^3/3 and t bound t - atan(t) from its two ends
  for (int i = 0; i < 60; ++i) {
    const double step = (t - std::atan(t) - inv) * (1.0 + t * t) / (t * t);
    t -= step;
    if (std::abs(step) <= 1e-16 * t) break;
  }
  return std::atan(t);
}

}  // namespace loadpath::gear
