// Orders of excitation of a shaft next to the gears on it.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

std::vector<ReducedLoad> excitations_of(const Step& step, const Project& project);

}  // namespace loadpath::project
