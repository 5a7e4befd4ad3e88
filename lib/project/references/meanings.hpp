// What values are beyond their dimension: no value is handed on as what it is not. A fatigue limit in bending is none
// in shear (lib/calculator/meaning.hpp), and a shear stress is no normal one.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Called before a step is solved, when those that it refers to are. A value handed on as what it is not becomes an
/// issue, and so does a word that is typed beside a record that has another.
void check_meanings(const Step& step, const Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
