// Columns next to [values] that no step takes.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs of a column that need a reason: an eccentricity or a bending moment is stated, or a stroke that is longer.
std::vector<ReducedLoad> columns_stated_otherwise(const Step& step, const Project& project);

}  // namespace loadpath::project
