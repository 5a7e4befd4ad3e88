// Nominal stresses at a notch, compared with their fatigue limits (NotchClaim in lib/calculator/meaning.hpp).
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Limits of the step that do not hold the notch at which a stress is nominal.
std::vector<ReducedLoad> missed_notches(const Step& step, const Project& project);

/// Whether a step hands over a notch of the shaft: a key, a press fit.
bool makes_notch(const Step* step);

}  // namespace loadpath::project
