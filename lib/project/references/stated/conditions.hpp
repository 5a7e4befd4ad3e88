// Conditions of service that [values] state and no step takes.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// An overspeed, a reliability, load cycles, openings of a vessel, a dynamic factor, a residual stress, a corrosive
/// environment, a low temperature.
std::vector<ReducedLoad> conditions_stated_only(const Step& step, const Project& project);

}  // namespace loadpath::project
