// Steps that describe parts of one machine and do not refer to each other: two bearings of a pair, a motor that runs up
// without its hoist.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs that another step gives, or contradicts, and that need a reason.
std::vector<ReducedLoad> values_of_unlinked(const Step& step, const Project& project);

}  // namespace loadpath::project
