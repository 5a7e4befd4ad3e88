// The words of commands with many options.
#pragma once

#include "cli/commands.hpp"
#include "cli/files/commands.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace loadpath::cli {

/// The action of the program once all words are read.
using Action = std::function<int()>;

/// Adds the output options of every solving command.
void add_output(CLI::App& app, OutputOptions& output);
/// Fields that the command line sets.
void add_settings(CLI::App& app, std::vector<std::string>& settings);
/// Adds the options for the points of a sweep.
void add_points(CLI::App& app, PointOptions& options);
void setup_sweep(CLI::App& app, SweepOptions& options, Action& action);

/// The functions that set up the words of a command, once it is named.
using Late = std::map<const CLI::App*, std::function<void()>>;
/// Commands about project files as texts.
void setup_init(CLI::App& app, InitOptions& options, Action& action);
void setup_diff(CLI::App& app, DiffOptions& options, Action& action);
void setup_fmt(CLI::App& app, FmtOptions& options, Action& action);

/// Every element of the catalogue. Its calculators and their flags are set up once it is named: setting up all would
/// take longer than most commands.
void setup_elements(CLI::App& app, CalculateOptions& options, Action& action, Late& late);

/// The name "torsion" in shaft.torsion.
std::string name_in_element(const Calculator& calculator);

}  // namespace loadpath::cli
