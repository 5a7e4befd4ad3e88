// Values that are taken from another part, or from another state of it, than the value next to them.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs that need a reason: a fatigue limit of another material or size, or above the limit that it is computed
/// from; a component of a force, and the force of a guide for a pin; the torque of a connection below that of the shaft
/// which its diameter comes from; a ratio of speeds that is not the ratio which it refers to; a run of a drive at a
/// speed, by a motor or without a flywheel that is not of the other steps. The steps that it refers to are solved.
std::vector<ReducedLoad> values_of_others(const Step& step, const Project& project);

}  // namespace loadpath::project
