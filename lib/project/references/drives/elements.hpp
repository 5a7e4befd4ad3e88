// The torque of the other element of a drive: of the worm for the key of its wheel.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// The torque of this step, if it is below that of the shaft of the only drive of the file which its title names, and
/// computed from the load of this drive.
std::vector<ReducedLoad> torques_of_other_elements(const Step& step, const Project& project);

}  // namespace loadpath::project
