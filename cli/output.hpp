// The outputs of solving commands: report files, JSON, CSV. Everything is made before anything is written.
#pragma once

#include "cli/options.hpp"
#include "lib/project/project.hpp"
#include "lib/report/detail.hpp"
#include "lib/report/document.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace loadpath::cli {

/// Whether the requested files can be made at all; prints the reason if not on standard error.
bool can_write(const OutputOptions& options);

/// Whether a file can be put there, with a message: not onto a folder, nor below a file.
bool can_place(const std::string& path);

/// Whether an output is meant for standard output, where the results are not shown then.
bool takes_standard_output(const OutputOptions& options);

/// Writes a document as the reports of these names; false if a file cannot be written.
bool write_reports(const report::Document& document, const std::vector<std::string>& paths,
                   const project::Project& project, bool quiet);

/// Whether an output would overwrite an input of the program, or another output; with a message.
bool overwrites(const std::vector<std::filesystem::path>& outputs, const project::Project& project);

/// Writes them, `input` into a full report; false if a file cannot be written.
bool write(const project::Project& project, const OutputOptions& options, const std::string& input);

/// The level of detail: from the shell, or else the usual one.
report::Detail detail_of(const OutputOptions& options, report::Detail usual);

}  // namespace loadpath::cli
