// A drive that takes its load from a shaft of a train: it has the ratio of the stage behind this shaft.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// The teeth or diameters of such a drive, where the stage has another ratio: the shafts behind it then have another
/// speed and torque. They need a reason.
std::vector<ReducedLoad> ratios_of_stages(const Step& step, const Project& project);

}  // namespace loadpath::project
