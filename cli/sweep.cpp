#include "cli/commands.hpp"

namespace loadpath::cli {
int sweep(const SweepOptions& options) { return options.file.empty() ? passed : fault; }
}  // namespace loadpath::cli
