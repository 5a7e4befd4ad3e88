// Where the power of the drive goes over a whole turn: friction, useful work, efficiency.
#pragma once

#include "calculators/mechanism/results/output.hpp"
#include "lib/account/account.hpp"

#include <optional>

namespace loadpath::planar {

/// Nothing for a mechanism without friction and useful loads, or without a whole turn: no mean says anything then.
std::optional<account::Table> efficiency_table(const account::Account& account, const Axis* axis);

/// drive.efficiency, and drive.efficiency_back of a machine that is driven by its load: of a mechanism with a crank and
/// friction or useful loads. Where it is not defined there is a reason.
void add_efficiency_outputs(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out);
void list_efficiency_patterns(std::vector<ResultPattern>& patterns);

}  // namespace loadpath::planar
