// The typed torque of a connection next to that of a machine: the same torque on the same shaft, whose application
// factor the connection leaves out.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// For keys, splines and other connections with a typed torque and without K_A and T_max.
std::vector<ReducedLoad> factors_of_torque(const Step& step, const Project& project);

}  // namespace loadpath::project
