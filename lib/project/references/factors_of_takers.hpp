// Factors that the steps which take a load of a step apply to it, and that the step itself leaves out.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// The message for a load whose application or partial factor is higher in a step that takes it; empty if there is
/// none, or for a reason. A reason is noted as needed.
Message factor_of_takers(Step& step, const Project& project);

}  // namespace loadpath::project
