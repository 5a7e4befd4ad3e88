// Factors that are lost between two steps: a nominal load does not include the factor of the step that it comes from.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// The factor not included in a load of another step, and neither taken nor given here, with the remedy; empty if
/// there is none. A lower factor with a reason is noted in the step.
Message missing_factor(Step& step, const Project& project, const Factors& held);

}  // namespace loadpath::project
