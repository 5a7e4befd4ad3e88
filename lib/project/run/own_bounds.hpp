// Typed values compared with the bounds of their calculator (lib/calculator/bound.hpp).
#pragma once

#include "lib/project/run/neighbours.hpp"

#include <vector>

namespace loadpath::project {

/// A bound without a value here is NaN: at another point of a sweep it may have one.
void add_own_bounds(const Evaluation& evaluation, const Known& known, std::vector<Neighbour>& all);

}  // namespace loadpath::project
