// Inputs that the other steps of the same machine contradict: factors, runs of drives, required lives, places of gears.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Adds those that nobody answers for to the loads of the step that are not assessed; after check_reductions.
void check_machine(Step& step, const Project& project);

}  // namespace loadpath::project
