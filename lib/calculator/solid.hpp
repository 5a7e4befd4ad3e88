// The meaning of a diameter in formulas of solid shafts: a hollow one needs others.
#pragma once

namespace loadpath {

inline constexpr auto diameter_of_solid = "a diameter of a solid shaft";

}  // namespace loadpath
