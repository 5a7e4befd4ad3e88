// Factors that travel with loads: a service factor counts once on the way from the machine to the part.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Called before a step is solved, when those that it refers to are. Loads that hold a factor which the step would
/// apply again, and loads of which some hold one and some do not, become issues. The step then knows what its loads
/// hold.
void check_factors(Step& step, const Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
