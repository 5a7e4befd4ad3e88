// What solving commands write: report files, JSON, CSV. Everything is made before anything is written.
#pragma once

#include "cli/commands.hpp"
#include "lib/project/project.hpp"

namespace loadpath::cli {

/// Whether the files that are asked for can be made at all; says why not on standard error.
bool can_write(const OutputOptions& options);

/// Writes them; false where a file cannot be written.
bool write(const project::Project& project, const OutputOptions& options);

}  // namespace loadpath::cli
