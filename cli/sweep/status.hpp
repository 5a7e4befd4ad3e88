// `loadpath sweep --status DIR`: the progress of the sweep in a folder, whichever process works or has worked on it.
#pragma once

#include "cli/commands.hpp"

namespace loadpath::cli {

/// The exit code: not_passed where points are missing.
int print_status(const SweepOptions& options);

}  // namespace loadpath::cli
