// Parts of a vessel next to each other: an end and a wall under vacuum next to the shell, and what they take of it.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs that another part of the vessel gives, or contradicts, and that need a reason.
std::vector<ReducedLoad> values_of_vessels(const Step& step, const Project& project);

}  // namespace loadpath::project
