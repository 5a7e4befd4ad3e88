// What stands in a column where a point has no value.
#pragma once

#include <limits>

namespace loadpath {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace loadpath
