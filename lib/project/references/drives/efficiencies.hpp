// Loads in front of losses: the useful output of a drive multiplied by an efficiency instead of divided by it.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Powers and torques of this step that are less than the useful output they are computed from: a force at a speed, a
/// pressure with a flow, a force on a screw, a torque of the driven side, times an efficiency. A power times an
/// efficiency is what is left behind the losses.
std::vector<ReducedLoad> efficiencies_of_outputs(const Step& step, const Project& project);

}  // namespace loadpath::project
