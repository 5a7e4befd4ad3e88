// Whether the value of an expression is of the kind that its field takes (lib/quantity/kinds.hpp).
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Called in order of evaluation, when the step is prepared and before it is solved, when more words are known: a shear
/// stress for a normal stress, a frequency for an angular velocity become issues.
void check_kinds(const Step& step, const Project& project, const Declared& declared, std::vector<Issue>& issues);

}  // namespace loadpath::project
