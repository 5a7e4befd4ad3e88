// Sizes, numbers of teeth and masses of [values] that are named by a word of the part, or by a state of it.
#pragma once

#include "lib/project/references/references.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs that need a reason: those of a step with a size of the same symbol, where no step has the size of [values],
/// as "D_flywheel" next to another D, "L_unsupported" next to a shorter L, "z_pinion", "J_press".
std::vector<ReducedLoad> sizes_of_parts_stated(const Step& step, const Project& project);

}  // namespace loadpath::project
