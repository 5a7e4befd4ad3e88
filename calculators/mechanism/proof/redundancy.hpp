// What a planar mechanism says whose joints hold more than is needed: which reactions are not unique. Those are never
// shown.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "lib/account/block.hpp"
#include "lib/mechanism/structure/structure.hpp"

#include <string>
#include <vector>

namespace loadpath::planar {

/// A line for each set of joints that hold a freedom too many. `cycle.unique` is not empty.
std::vector<account::Verdict> redundancies(const std::string& step, const mechanism::Model& model,
                                           const mechanism::Structure& structure);
/// For each joint whether its force and its couple are unique.
account::Table uniqueness_table(const mechanism::Model& model, const Cycle& cycle);
/// Puts no number in the place of each reaction that is not unique.
void hide_what_is_not_unique(Cycle& cycle);
/// A mechanism that moves alike without holding too much, for what is computed from solved positions.
mechanism::Model determinate(const mechanism::Model& model, const Cycle& cycle);

}  // namespace loadpath::planar
