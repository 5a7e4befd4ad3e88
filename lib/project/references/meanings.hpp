// Meanings of values beyond their dimension: no value is used with another meaning. A fatigue limit in bending does
// not apply in shear (lib/calculator/meaning.hpp), and a shear stress is not a normal stress.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Called before a step is solved, after the steps that it refers to. A value used with another meaning becomes an
/// issue, and so does a typed word that contradicts a record.
void check_meanings(const Step& step, const Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
