// What a planar mechanism says in tables: its model, extremes, reactions, structure.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "lib/account/account.hpp"
#include "lib/mechanism/structure/structure.hpp"

#include <vector>

namespace loadpath::planar {

/// Links, joints, drives and loads as tables.
std::vector<account::Block> model_tables(const Mechanism::Input& in);
/// Largest and smallest of drives and reactions over the cycle, or the reactions at the one position; the groups that
/// the mechanism is built of, and how well the equations determine it.
std::vector<account::Block> result_tables(const account::Account& account, const mechanism::Model& model,
                                          const mechanism::Structure& structure, const Cycle& cycle, const Axis* axis);

}  // namespace loadpath::planar
