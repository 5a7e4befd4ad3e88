// A load of [values] that no step takes.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Loads of the step below an unused value of [values], down to a tenth of it, and factors below one of their own name:
/// a starting torque that is written down and acts on nothing needs a reason.
std::vector<ReducedLoad> loads_left_out(const Step& step, const Project& project);

}  // namespace loadpath::project
