// Values of [values] that no step takes, under the names of results and of their limits.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs that need a reason: the file states a ratio, a size, a speed or a time under the name of a result that is
/// another one ("i = 4", "n_2"), or a limit that an input or a result does not keep ("v_max", "d_min").
std::vector<ReducedLoad> results_stated_otherwise(const Step& step, const Project& project);

}  // namespace loadpath::project
