#pragma once

#include <cmath>

namespace loadpath {

/// The larger magnitude; what is not a number stays so.
inline double larger_magnitude(double most, double x) {
  return std::isnan(most) || std::abs(x) <= most ? most : std::abs(x);
}

}  // namespace loadpath
