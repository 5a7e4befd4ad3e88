// What solving commands write: report files, JSON, CSV. Everything is made before anything is written.
#pragma once

#include "cli/options.hpp"
#include "lib/project/project.hpp"
#include "lib/report/detail.hpp"
#include "lib/report/document.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace loadpath::cli {

/// Whether the files that are asked for can be made at all; says why not on standard error.
bool can_write(const OutputOptions& options);

/// Whether a file can be put there: a folder cannot be written, nor what lies in a file; which is told.
bool can_place(const std::string& path);

/// Whether an output is meant for standard output, where the results are not shown then.
bool takes_standard_output(const OutputOptions& options);

/// Writes a document as the reports of these names; false where a file cannot be written.
bool write_reports(const report::Document& document, const std::vector<std::string>& paths,
                   const project::Project& project, bool quiet);

/// Whether an output would take the place of what the program reads, or of another output; which is told.
bool overwrites(const std::vector<std::filesystem::path>& outputs, const project::Project& project);

/// Writes them, `input` into a full report; false where a file cannot be written.
bool write(const project::Project& project, const OutputOptions& options, const std::string& input);

/// How much is told: what the shell says, or else what is usual.
report::Detail detail_of(const OutputOptions& options, report::Detail usual);

}  // namespace loadpath::cli
