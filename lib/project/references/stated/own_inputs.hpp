// Values and words of [values] under the names of inputs that have another value.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// "R_z = 100 um" that nothing refers to, next to an R_z of 6.3 um; "ends = pinned_pinned" next to fixed ends.
std::vector<ReducedLoad> inputs_stated_otherwise(const Step& step, const Project& project);

}  // namespace loadpath::project
