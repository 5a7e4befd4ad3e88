// Values of [values] that no step takes, and that name a row of a list.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Values of rows that need a reason: "J_rotor" of [values] next to the row "rotor" of a run-up with a lower J, "P_fan"
/// next to a pulley "fan" with less power, "b_wheel" next to a mounted component of another width.
std::vector<ReducedLoad> rows_stated_otherwise(const Step& step, const Project& project);

}  // namespace loadpath::project
