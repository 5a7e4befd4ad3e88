// The motor or brake of a run next to the shafts of its drive: a motor that is too weak for the torque at its speed, a
// start that the parts on this shaft are not assessed for.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// By how much a step covers a peak of its torque: k_max of a shaft, T_max over T of a connection, in magnitude; 1 if
/// it gives neither, or no torque.
double peak_factor_of(const Step& step, const Project& project);

/// For the step of a run.
std::vector<ReducedLoad> torques_of_line(const Step& step, const Project& project);

}  // namespace loadpath::project
