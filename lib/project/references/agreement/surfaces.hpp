// The finish of a surface next to its roughness.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

std::vector<ReducedLoad> surfaces_of(const Step& step, const Project& project);

}  // namespace loadpath::project
