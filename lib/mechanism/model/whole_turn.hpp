// The angle of a full revolution, rad.
#pragma once

#include <numbers>

namespace loadpath {

inline constexpr double whole_turn = 2.0 * std::numbers::pi;

}  // namespace loadpath
