// Whether a column of values keeps to bounds: what most points of a sweep do.
#pragma once

#include "lib/calculator/field.hpp"

#include <span>

namespace loadpath::project {

/// Whether every value is a number within the bounds.
bool all_within(const Range& bounds, std::span<const double> si);
/// Whether all are above zero, or all below.
bool all_act(std::span<const double> si);

}  // namespace loadpath::project
