// The motor or brake of a run next to the shafts of its drive: a motor that is too weak for the torque at its speed, a
// start that the parts on this shaft are not assessed for.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// For the step of a run.
std::vector<ReducedLoad> torques_of_line(const Step& step, const Project& project);

}  // namespace loadpath::project
