// `loadpath sweep` where it looks for a point instead of solving all of them: a best design, a value that meets a
// target, and the influence of the inputs.
#pragma once

#include "cli/sweep/planned.hpp"

namespace loadpath::cli {

/// --minimise and --maximise. The exit code, like that of the others: not_passed where nothing is found.
int choose(const PlannedSweep& sweep);
/// --seek
int seek(const PlannedSweep& sweep);
/// --influence and --sobol
int ask_influence(const PlannedSweep& sweep);

}  // namespace loadpath::cli
