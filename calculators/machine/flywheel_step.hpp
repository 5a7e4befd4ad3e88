// The step of a flywheel: its input is the full series of the moment; other calculators run once per position.
#pragma once

#include "lib/project/run/calculator_step.hpp"

#include <memory>

namespace loadpath::machine {

class FlywheelStep : public project::CalculatorStep {
 public:
  explicit FlywheelStep(project::StepInput&& input) : CalculatorStep(std::move(input)) {}

  void prepare(const project::Declared& declared, const project::Companions& companions,
               std::vector<Issue>& issues) override;
  void solve(const project::Known& known, const project::Wanted& wanted, std::vector<Issue>& issues) override;

 private:
  /// Takes the moment's expression away from the inputs that are lifted, and checks that it is a series.
  void take_series(const project::Declared& declared, std::vector<Issue>& issues);
  /// Puts the series into the input; false and an issue if it is not a cycle, or not known everywhere.
  bool fill(const Value& series, const project::Known& known, std::vector<Issue>& issues);
  /// Value of a typed input, or of an expression.
  [[nodiscard]] double number(const char* key, double typed, const project::Known& known) const;
};

std::unique_ptr<project::Step> make_flywheel_step(project::StepInput&& input);

}  // namespace loadpath::machine
