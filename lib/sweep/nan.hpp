// The value of a missing result in a column of a sweep.
#pragma once

#include <limits>

namespace loadpath {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace loadpath
