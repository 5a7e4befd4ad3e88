// The common part of `run` and the calculators of the shell: read, solve, write, show, and the exit code.
#pragma once

#include "calculators/catalogue.hpp"
#include "cli/options.hpp"
#include "lib/account/conclusion.hpp"
#include "lib/report/terminal/terminal.hpp"

#include <functional>

namespace loadpath::cli {

using ReadProject = std::function<project::Project(std::vector<Issue>& issues)>;

/// `usual`: the level of detail of the terminal's tables if the shell does not give it; full: for one calculator.
int solve_and_show(const ReadProject& read, const std::vector<terminal::SourceText>& sources,
                   const OutputOptions& output, report::Detail usual);

/// The source texts for issues: these, and the further files that the project was read from.
std::vector<terminal::SourceText> with_files_of(const project::Project& project,
                                                std::vector<terminal::SourceText> sources);

/// The exit code of a headline.
int exit_for(account::Headline headline);

/// The exit code that failure modes amount to.
int exit_for(const account::Modes& modes);

}  // namespace loadpath::cli
