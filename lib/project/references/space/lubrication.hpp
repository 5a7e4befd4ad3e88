// Bearings of one machine: lubricant and cleanliness given for one of them concern all.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// The viscosity and the contamination that a bearing does not give, and another one of the machine does: without them
/// its rating life has a_ISO = 1.
std::vector<ReducedLoad> lubrication_of_others(const Step& step, const Project& project);

}  // namespace loadpath::project
