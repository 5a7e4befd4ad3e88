// Sizes and masses of one part that two steps state: the section of a fatigue limit and that of the part, a mass on a
// shaft and the moment of inertia that comes from the step of its rim.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

std::vector<ReducedLoad> sizes_in_disagreement(const Step& step, const Project& project);

}  // namespace loadpath::project
