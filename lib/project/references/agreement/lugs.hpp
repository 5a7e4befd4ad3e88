// Lugs and plates of pins that a mechanism loads: nominal stresses of a lug, and end distances of a plate, hold for a
// force along its axis, and the force of a joint may turn away from the axis of a link, as that of a rod on a crank
// does.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// For the step of a lug, or of a pin with its plates, on a bar that the force crosses.
std::vector<ReducedLoad> forces_across_lugs(const Step& step, const Project& project);

}  // namespace loadpath::project
