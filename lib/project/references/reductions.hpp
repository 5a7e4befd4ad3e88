// Loads smaller than the series that they come from: the mean of a force, its value at one place, the larger of two
// extremes. The reduction persists through arithmetic and through other steps.
#pragma once

#include "lib/project/project.hpp"

#include <string>
#include <vector>

namespace loadpath::project {

/// Gives the step its loads of this kind; the steps that it refers to are solved.
void check_reductions(Step& step, const Project& project);

/// Whether the user answers for the reduction of a load: because.F = "...".
bool is_reduction_justified(const Step& step, const std::string& path);

}  // namespace loadpath::project
