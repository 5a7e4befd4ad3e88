// The inputs that would permit an assessment, and that a step does not have yet.
#pragma once

#include "lib/project/step.hpp"

#include <string>

namespace loadpath::project {

/// Those among "S, A_v" that are neither typed, nor taken from another step, nor given by the row that the step names.
std::string still_wanted(const Step& step, const char* wants);

/// The inputs that the limits of a mode compare with, "d_min", where none of those of a limit is given; empty if the
/// mode has a remedy of its own.
std::string wanted_by_limits(const Step& step, const ModeInfo& mode);

}  // namespace loadpath::project
