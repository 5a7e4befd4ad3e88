// Texts for a mechanism without forces, or without any position: in the verdict, and with every result that misses
// values there.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/results/output.hpp"
#include "lib/account/block.hpp"

#include <optional>
#include <string>

namespace loadpath::planar {

/// None where every spring has a direction to act in. `axis` is null where there is one position.
std::optional<account::Verdict> direction_of_springs(const std::string& step, const Mechanism::Input& in,
                                                     const Cycle& cycle, const Axis* axis);

/// Gives values that are missing only where the mechanism does not close, jams or has no forces that reason, and what
/// joints that hold too much leave open its own.
void explain_missing(const Mechanism::Input& in, const Cycle& cycle, Output::Values& values);

}  // namespace loadpath::planar
