// The proof of a planar mechanism: closing, equilibrium, power, and the reactions and drives found again.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "lib/account/verdict.hpp"

#include <string>
#include <vector>

namespace loadpath::planar {

/// Whether it closes everywhere; the equilibrium of every link and the power balance; the forces found again by other
/// methods, and the positions that are not trustworthy.
std::vector<account::Verdict> proof(const std::string& step, const Mechanism::Input& in, const mechanism::Model& model,
                                    const Cycle& cycle, const Axis* axis);

}  // namespace loadpath::planar
