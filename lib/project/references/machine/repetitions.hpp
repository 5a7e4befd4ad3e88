// Repetitions of a load: of two steps with one history, of a history over one turn, of the blocks of a bearing.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Numbers of repetitions and speeds of blocks that need a reason next to those of other steps.
std::vector<ReducedLoad> repetitions_of_others(const Step& step, const Project& project);

}  // namespace loadpath::project
