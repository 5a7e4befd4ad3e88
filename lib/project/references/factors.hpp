// Factors included in loads: an application factor is applied once between the driving machine and the part.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Called before a step is solved, when those that it refers to are. Loads that hold a factor which the step would
/// apply again, and loads of which some hold one and some do not, become issues. The step then knows what its loads
/// hold.
void check_factors(Step& step, const Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
