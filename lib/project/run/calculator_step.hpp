// The step that runs a calculator: expressions into inputs, values from tables, a search for sizes, the calculation at
// every position of a cycle where an input is a series.
#pragma once

#include "lib/project/run/evaluation/prepared_step.hpp"

namespace loadpath::project {

class CalculatorStep : public PreparedStep {
 public:
  using PreparedStep::PreparedStep;

  void solve_without(const std::set<std::string>& inputs, const Known& known) override;
  void solve(const Known& known, const Wanted& wanted, std::vector<Issue>& issues) override;

  /// Known once it is solved: typed inputs that rows and records for the same fields were compared with, and whether
  /// that must be done at every point of a sweep.
  [[nodiscard]] const std::vector<std::string>& compared() const { return compared_; }
  [[nodiscard]] bool goes_point_by_point() const { return goes_point_by_point_; }

 private:
  std::vector<std::string> compared_;
  bool goes_point_by_point_ = false;
};

/// The step of an ordinary calculator.
std::unique_ptr<Step> make_calculator_step(StepInput&& input);

}  // namespace loadpath::project
