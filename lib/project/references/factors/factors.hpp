// Factors included in loads: an application factor is applied once between the driving machine and the part.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Called before a step is solved, after the steps that it refers to. Loads that include a factor which the step
/// would apply again, and loads of which only some include one, become issues. The step then knows the factors of its
/// loads.
void check_factors(Step& step, const Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
