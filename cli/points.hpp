// The points of a project's sweep, as the file and the shell say them.
#pragma once

#include "cli/commands.hpp"
#include "lib/project/sweep/plan.hpp"

namespace loadpath::cli {

/// What the shell says in place of the file.
void take_points(const PointOptions& options, project::SweepSettings& settings);

/// The machine of one point, with its number in the heading; issues where there is no such point.
void take_point(project::Project& project, std::uint64_t point, std::vector<Issue>& issues);

}  // namespace loadpath::cli
