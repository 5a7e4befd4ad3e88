// The length of a column that is computed from the step which finds its effective length.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

std::vector<ReducedLoad> lengths_of_columns(const Step& step, const Project& project);

}  // namespace loadpath::project
