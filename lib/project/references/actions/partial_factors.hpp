// Partial factors of actions in the formulas of loads.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Loads of this step that miss a partial factor: a term of a sum without one, characteristic values alone, a
/// combination factor on another action; and loads that are too small although each term has one: a vertical action
/// that is subtracted with it, a root of squares of vertical actions.
std::vector<ReducedLoad> partial_factors_of_loads(const Step& step, const Project& project);

}  // namespace loadpath::project
