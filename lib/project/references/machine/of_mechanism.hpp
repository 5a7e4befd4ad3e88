// Loads of a mechanism: over its cycle, and not of less than the step says beside it.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Loads of a mechanism that is solved at given crank angles only, and a typed force below that of every joint of a
/// mechanism which other inputs of the step come from. They need a reason.
std::vector<ReducedLoad> loads_of_mechanism(const Step& step, const Project& project);

}  // namespace loadpath::project
