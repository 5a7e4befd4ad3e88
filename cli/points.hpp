// The points of a project's sweep, from the file and the shell.
#pragma once

#include "cli/options.hpp"
#include "lib/project/sweep/blocks.hpp"

namespace loadpath::cli {

/// Takes the options of the shell in place of the file's.
void take_points(const PointOptions& options, project::SweepSettings& settings);

/// The message for an option of a sweep without a point, as --zip; empty if there is none.
std::string needs_point(const PointOptions& options);

/// The design of one point, with its number in the heading; issues if there is no such point.
void take_point(project::Project& project, std::uint64_t point, std::vector<Issue>& issues);

/// The blocks of a share, "2/10" or its points, "512-1023". A Fault if there is none such.
Outcome<project::BlockRange> read_share(const std::string& text, const project::SweepPlan& plan);

}  // namespace loadpath::cli
