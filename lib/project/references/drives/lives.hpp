// Required lives of parts of one machine.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// A required life that is shorter than that of another part on the same shaft: bearings, and the teeth of its gears.
std::vector<ReducedLoad> lives_on_shaft(const Step& step, const Project& project);

}  // namespace loadpath::project
