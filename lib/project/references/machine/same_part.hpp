// A size or a stress cycle taken from another step belongs to the part of that step: its bore and its material go with
// it.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs that need a reason: a diameter of a hollow part without its bore, a size or cycle of a part of a weaker or
/// another material, a radius taken for a diameter.
std::vector<ReducedLoad> values_of_same_part(const Step& step, const Project& project);

/// Whether the step takes a size of another one: at another point of a sweep that may have another bore.
bool takes_sizes(const Step& step, const Project& project);

}  // namespace loadpath::project
