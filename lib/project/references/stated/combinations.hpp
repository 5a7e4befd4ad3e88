// Loads that are combined of values of [values], and the values of the same kind that the combination leaves out.
#pragma once

#include "lib/project/references/references.hpp"

#include <vector>

namespace loadpath::project {

/// Loads that need a reason: a sum with partial factors of which a term has none, "=1.35*values.G + values.Q"; a sum of
/// forces next to an action that no step takes, "Q_snow"; a load next to its factor, "f_F" of F; one end of a cycle
/// next to the other of the same name, "F_min" of F_max.
std::vector<ReducedLoad> values_left_out_of_loads(const Step& step, const Project& project);

}  // namespace loadpath::project
