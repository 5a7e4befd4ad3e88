// What [values] state and no step takes, under the names of inputs and under words that are customary for a condition.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

std::vector<ReducedLoad> values_not_taken(const Step& step, const Project& project);

}  // namespace loadpath::project
