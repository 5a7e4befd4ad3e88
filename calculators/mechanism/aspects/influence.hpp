// What the forces of a mechanism hang on, at its governing position: who causes them, and what changes them.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "lib/account/block.hpp"

#include <vector>

namespace loadpath::planar {

/// Every reaction and effort split by cause, and the change of the drive by the dimensions and masses that change it
/// most. None where the position has no forces.
std::vector<account::Table> influence_tables(const mechanism::Model& model, const Cycle& cycle, std::size_t governing,
                                             bool statics);

}  // namespace loadpath::planar
