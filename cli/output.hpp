// What solving commands write: report files, JSON, CSV. Everything is made before anything is written.
#pragma once

#include "cli/commands.hpp"
#include "lib/project/project.hpp"
#include "lib/report/document.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace loadpath::cli {

/// Whether the files that are asked for can be made at all; says why not on standard error.
bool can_write(const OutputOptions& options);

/// Writes a document as the reports of these names; false where a file cannot be written.
bool write_reports(const report::Document& document, const std::vector<std::string>& paths,
                   const project::Project& project, bool quiet);

/// Whether an output would take the place of what the program reads, or of another output; which is told.
bool overwrites(const std::vector<std::filesystem::path>& outputs, const project::Project& project);

/// Writes them; false where a file cannot be written.
bool write(const project::Project& project, const OutputOptions& options);

}  // namespace loadpath::cli
