// Uncertain inputs of a run, which takes the middle of each.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs at the middle of their distribution: half of all parts may be worse, so no mode of strength is assessed.
std::vector<ReducedLoad> values_at_middle(const Step& step);

}  // namespace loadpath::project
