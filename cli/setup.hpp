// The words of commands that have many: what the shell takes, as options.
#pragma once

#include "cli/commands.hpp"

#include <CLI/CLI.hpp>

#include <functional>

namespace loadpath::cli {

/// What the program does once all words are read.
using Action = std::function<int()>;

/// Which points a sweep has.
void add_points(CLI::App& app, PointOptions& options);
void setup_sweep(CLI::App& app, SweepOptions& options, Action& action);

}  // namespace loadpath::cli
