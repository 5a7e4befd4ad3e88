// The positions at which loads, weights and springs hold a mechanism in equilibrium without its drive.
#pragma once

#include "calculators/mechanism/cycle/equilibrium.hpp"
#include "calculators/mechanism/cycle/schedule.hpp"
#include "lib/text/issue.hpp"

#include <vector>

namespace loadpath::planar {

/// Between the first position and the last, wherever the mechanism closes. Its drive is at rest, without inertia.
Equilibria equilibria_of(const Mechanism::Input& in, const mechanism::Model& model, bool redundant,
                         const std::vector<double>& places, const Assembled& assembled);

/// What an analysis of equilibrium does not take: friction, a motion, several drives.
std::vector<FieldFault> check_equilibrium(const Mechanism::Input& in, const mechanism::Model& model);

}  // namespace loadpath::planar
