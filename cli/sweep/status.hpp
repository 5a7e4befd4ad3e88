// `loadpath sweep --status DIR`: how far the sweep in a folder is, whoever works or has worked on it.
#pragma once

#include "cli/commands.hpp"

namespace loadpath::cli {

/// The exit code: not_passed where points are missing.
int tell_status(const SweepOptions& options);

}  // namespace loadpath::cli
