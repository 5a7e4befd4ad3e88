// Mechanisms whose joints hold more than is needed: not every reaction is unique.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"

namespace loadpath::planar {

/// The cycle with no number in the place of each reaction that is not unique.
Cycle without_what_is_not_unique(Cycle cycle);
/// A mechanism that moves alike without holding too much, for what is computed from solved positions.
mechanism::Model determinate(const mechanism::Model& model, const Cycle& cycle);

}  // namespace loadpath::planar
