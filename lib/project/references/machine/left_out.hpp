// A load of [values] that no step takes.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// The loads of the step that such a value exceeds, up to tenfold: a starting torque that is written down and acts on
/// nothing needs a reason.
std::vector<ReducedLoad> loads_left_out(const Step& step, const Project& project);

}  // namespace loadpath::project
