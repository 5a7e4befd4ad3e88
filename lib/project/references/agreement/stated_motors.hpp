// A motor of [values] that no step takes, next to the drive of the file: its power, its torque, its speed.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// For the first step with a speed that is typed: the drive begins there.
std::vector<ReducedLoad> motors_stated_only(const Step& step, const Project& project);

}  // namespace loadpath::project
