// Loads from a mechanism: over its full cycle, and typed forces not below its joint forces.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Loads of a mechanism that is solved at given crank angles only, and a typed force below that of every joint of a
/// mechanism which other inputs of the step come from. They need a reason.
std::vector<ReducedLoad> loads_of_mechanism(const Step& step, const Project& project);

}  // namespace loadpath::project
