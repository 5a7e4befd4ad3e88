// Drives of one machine that disagree: with the stage of their train, with each other, and with loads of [values].
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// All of them, as far as the steps are solved.
std::vector<ReducedLoad> values_of_drives(const Step& step, const Project& project);

}  // namespace loadpath::project
