// The step that runs a calculator: expressions into inputs, values from tables, a search for sizes, the calculation at
// every position of a cycle where an input is a series.
#pragma once

#include "lib/project/run/evaluation/prepared_step.hpp"
#include "lib/project/run/field_role.hpp"
#include "lib/project/run/search/search.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace loadpath::project {

/// A row among those of a search.
struct RowOfSearch {
  std::string name;
  double size;                // by which the rows are ordered: a mass
  std::vector<double> given;  // values that it gives to inputs, SI; NaN: none
};

class CalculatorStep : public PreparedStep {
 public:
  using PreparedStep::PreparedStep;

  void solve_without(const std::set<std::string>& inputs, const Known& known) override;
  void solve(const Known& known, const Wanted& wanted, std::vector<Issue>& issues) override;

  /// The rows of the one search of the step, ascending, with the values of some inputs that they fill.
  [[nodiscard]] std::vector<RowOfSearch> rows_of_search(const std::vector<std::string>& inputs) const;
  /// For every row that is the first of its kind the first of the same kind that passes, with the present values of
  /// other steps; the number of rows if none does. `alike`: for each row the first one of its kind.
  [[nodiscard]] std::vector<std::size_t> first_rows_that_pass(const Known& known,
                                                              std::span<const std::size_t> alike) const;
  /// The row that the next solution takes, found together with that of another step.
  void keep_to_row(JointRow row) { together_ = std::move(row); }

  /// Known once it is solved: typed inputs that rows and records for the same fields were compared with, each with the
  /// value up to which it needs no reason, NaN if that is not known; and whether all must be compared at every point.
  [[nodiscard]] const std::map<std::string, double>& compared() const { return compared_; }
  [[nodiscard]] bool goes_point_by_point() const { return goes_point_by_point_; }
  /// Bounds of the calculator that typed values keep, and have to keep at every point.
  [[nodiscard]] const std::vector<KeptBound>& kept_bounds() const { return kept_bounds_; }

 private:
  std::map<std::string, double> compared_;
  bool goes_point_by_point_ = false;
  std::vector<KeptBound> kept_bounds_;
  std::optional<JointRow> together_;
};

/// The step of an ordinary calculator.
std::unique_ptr<Step> make_calculator_step(StepInput&& input);

}  // namespace loadpath::project
