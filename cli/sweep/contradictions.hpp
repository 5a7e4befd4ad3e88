// Options of `loadpath sweep` that do not go together.
#pragma once

#include "cli/commands.hpp"

#include <string>

namespace loadpath::cli {

/// The contradiction between options of the command line; empty if there is none.
std::string contradiction(const SweepOptions& options);

}  // namespace loadpath::cli
