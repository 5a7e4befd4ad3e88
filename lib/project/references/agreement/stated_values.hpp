// Entries of [values] that no step takes and that concern this step by their names: peak factors, repetitions, required
// lives, strengths, a vacuum, a temperature. Loads and application factors are compared in left_out.hpp.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

std::vector<ReducedLoad> values_stated_only(const Step& step, const Project& project);

}  // namespace loadpath::project
