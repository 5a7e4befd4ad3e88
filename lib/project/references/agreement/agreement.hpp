// Inputs that another step, or another input of the same step, contradicts: torques and powers of one drive, sizes of
// one part, surfaces, excitations.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Of entries of [values] that no step takes, motors, lengths of columns, stages of trains, lugs: those that compare
/// numbers only, and need no step that takes them.
std::vector<ReducedLoad> statements_in_disagreement(const Step& step, const Project& project);

/// All of them, as far as the steps are solved.
std::vector<ReducedLoad> values_in_disagreement(const Step& step, const Project& project);

}  // namespace loadpath::project
