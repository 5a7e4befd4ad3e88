// Sizes of [values] of the parts that a part is mounted on, or runs on, and that no step takes.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs that need a reason: the bore of a hub or bearing next to another "d_shaft", a pin next to another "d_hole",
/// the plates of a pin next to another "t_fork", a belt or silent chain that is wider than "b_pulley".
std::vector<ReducedLoad> mates_stated_otherwise(const Step& step, const Project& project);

}  // namespace loadpath::project
