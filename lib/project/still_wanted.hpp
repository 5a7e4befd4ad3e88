// The inputs that would permit an assessment, and that a step does not have yet.
#pragma once

#include "lib/project/step.hpp"

#include <string>

namespace loadpath::project {

/// Those among "S, A_v" that are neither typed, nor taken from another step, nor given by the row that the step names.
std::string still_wanted(const Step& step, const char* wants);

}  // namespace loadpath::project
