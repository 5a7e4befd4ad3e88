// A sweep of a project: its points, in which order its inputs go through them, and what is read off each.
#pragma once

#include "lib/project/read/sweep_settings.hpp"
#include "lib/project/sweep/axes.hpp"
#include "lib/project/sweep/columns.hpp"
#include "lib/sweep/point/space.hpp"

#include <vector>

namespace loadpath::project {

struct SweepPlan {
  std::vector<SweptInput> inputs;      // in the order of the file
  std::vector<std::size_t> variables;  // of the space, that of each input
  std::vector<SweptResult> columns;    // as they were asked for
  sweep::Space space;

  /// What a table of points has beside the inputs, as numbers of the results: one that is an input stands there
  /// already.
  [[nodiscard]] std::vector<std::size_t> beside_inputs() const;
  /// The same with how the whole came out behind them, which has two columns.
  [[nodiscard]] std::vector<std::size_t> kept_results() const;
  /// The values of all inputs at a point.
  [[nodiscard]] std::vector<double> at(std::uint64_t index) const;
  /// A column for each input, for the points first ... first + n - 1.
  void fill(std::uint64_t first, std::size_t n, std::span<double* const> of_inputs) const;
};

/// What is wrong with names, zips, correlations, results becomes an issue.
SweepPlan plan_sweep(Project& project, const SweepSettings& settings, std::vector<Issue>& issues);

/// Gives all inputs the values of a point: the project is that of one machine then. Issues as of typed values.
void set_point(Project& project, const SweepPlan& plan, std::uint64_t index, std::vector<Issue>& issues);

}  // namespace loadpath::project
