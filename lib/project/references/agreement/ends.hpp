// An end of a vessel next to the shells of the same pressure: its radius, and the height of the water at the test.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

std::vector<ReducedLoad> ends_of_vessel(const Step& step, const Project& project);

}  // namespace loadpath::project
