// Factors that the steps which take a load of a step apply to it, and that the step itself leaves out.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Application and partial factors that are higher in a step which takes a load of this one.
std::vector<ReducedLoad> factors_of_takers(const Step& step, const Project& project);

}  // namespace loadpath::project
