// Results that no step takes, next to an input that is typed: a fatigue limit, an effective length factor.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Typed inputs that such a step gives. They need a reason.
std::vector<ReducedLoad> values_of_idle_steps(const Step& step, const Project& project);

}  // namespace loadpath::project
