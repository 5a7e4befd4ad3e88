// Contradictions and the reasons that answer them: because.F = "...".
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Adds values that need a reason to the loads that are not assessed; a reason that is given is not idle. It answers
/// one contradiction of its input: of several it names the values of the others.
void hold_unless_justified(Step& step, const std::vector<ReducedLoad>& values);

}  // namespace loadpath::project
