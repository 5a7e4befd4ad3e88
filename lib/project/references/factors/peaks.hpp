// Peaks of a start or a jam: a load that is taken without the peak factor of its step.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// What is missing of the peak load of another step, and the remedy; empty if nothing is.
Message missing_peak(const Step& step, const Project& project);

}  // namespace loadpath::project
