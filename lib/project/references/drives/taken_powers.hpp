// A drive that takes the power of another one, with a speed of its own.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Its speed, where the shaft that the power is taken from has another one. It needs a reason.
std::vector<ReducedLoad> speeds_of_taken_powers(const Step& step, const Project& project);

}  // namespace loadpath::project
