// The angle of a whole turn, rad.
#pragma once

#include <numbers>

namespace loadpath {

inline constexpr double whole_turn = 2.0 * std::numbers::pi;

}  // namespace loadpath
