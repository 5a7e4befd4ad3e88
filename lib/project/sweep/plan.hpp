// A sweep of a project: its points, the order of its inputs, and the values read at each.
#pragma once

#include "lib/project/read/sweep_settings.hpp"
#include "lib/project/sweep/axes.hpp"
#include "lib/project/sweep/columns.hpp"
#include "lib/sweep/point/space.hpp"

#include <span>
#include <vector>

namespace loadpath::project {

struct SweepPlan {
  std::vector<SweptInput> inputs;      // in the order of the file
  std::vector<std::size_t> variables;  // variable of the space for each input
  std::vector<SweptResult> columns;    // as requested, then those of demands
  std::size_t demands = 0;             // columns of demands, which no table shows
  sweep::Space space;

  [[nodiscard]] std::span<const SweptResult> requested() const {
    return std::span(columns).first(columns.size() - demands);
  }
  /// The columns of a table of points in addition to the inputs, as indices of the results: a result that is an input
  /// is omitted.
  [[nodiscard]] std::vector<std::size_t> output_columns() const;
  /// The same, followed by the two columns of the overall verdict.
  [[nodiscard]] std::vector<std::size_t> kept_results() const;
  /// The values of all inputs at a point.
  [[nodiscard]] std::vector<double> at(std::uint64_t index) const;
  /// A column for each input, for the points first ... first + n - 1.
  void fill(std::uint64_t first, std::size_t n, std::span<double* const> of_inputs) const;
};

/// Whether there are several designs, each with samples of uncertain inputs.
inline bool has_scattering_designs(const SweepPlan& plan) {
  return plan.space.samples() > 1 && plan.space.count() > plan.space.samples();
}

/// The points of these inputs; `variables`: the variable of each. Errors in zips and correlations become issues.
sweep::Space space_of(const std::vector<SweptInput>& inputs, const SweepSettings& settings,
                      std::vector<std::size_t>& variables, std::vector<Issue>& issues);

/// Errors in names, zips, correlations and results become issues.
SweepPlan plan_sweep(Project& project, const SweepSettings& settings, std::vector<Issue>& issues);

/// Reports ranges of designs without steps: only a search of the best design chooses from them.
void refuse_open_ranges(const SweepPlan& plan, std::vector<Issue>& issues);

/// Sets all inputs to the values of a point: the project is then a single design. Issues as for typed values.
void set_point(Project& project, const SweepPlan& plan, std::uint64_t index, std::vector<Issue>& issues);

}  // namespace loadpath::project
