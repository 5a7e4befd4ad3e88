// Powers next to the speed of another shaft.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// The speed of a drive, where the shaft that the power is taken from has another one. It needs a reason.
std::vector<ReducedLoad> speeds_of_taken_powers(const Step& step, const Project& project);

/// A torque of a power at the speed of a faster shaft than the one that the step is named after: T = P/n_motor of a key
/// of the fan shaft, next to n_fan. It needs a reason.
std::vector<ReducedLoad> torques_of_faster_shafts(const Step& step, const Project& project);

}  // namespace loadpath::project
