// Whether a column of values is within bounds: true at most points of a sweep.
#pragma once

#include "lib/calculator/field.hpp"

#include <span>

namespace loadpath::project {

/// Whether every value is a number within the bounds.
bool all_within(const Range& bounds, std::span<const double> si);
/// Whether all are above zero, or all below.
bool all_act(std::span<const double> si);

}  // namespace loadpath::project
