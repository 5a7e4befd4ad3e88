// The step of a machine's motion: load and reduced inertia are full series of a cycle; other calculators run once per
// position.
#pragma once

#include "lib/project/run/calculator_step.hpp"

#include <memory>
#include <string>

namespace loadpath::machine {

class MotionStep : public project::CalculatorStep {
 public:
  explicit MotionStep(project::StepInput&& input) : CalculatorStep(std::move(input)) {}

  void prepare(const project::Declared& declared, const project::Companions& companions,
               std::vector<Issue>& issues) override;
  void solve(const project::Known& known, const project::Wanted& wanted, std::vector<Issue>& issues) override;

 private:
  /// Takes an expression that is a series away from the inputs that are lifted; a single value stays there.
  void take_series(const std::string& key, const project::Declared& declared, std::vector<Issue>& issues);
  /// Puts a series into the input; false and an issue if it is not a cycle, or not known everywhere.
  bool fill(const project::Operand& operand, const Value& series, std::vector<Issue>& issues);
  /// Whether the load may be a moment that includes inertia forces, while nothing says so.
  bool counts_inertia_twice(const project::Operand& operand, const project::Known& known,
                            std::vector<Issue>& issues) const;
  /// Whether the load is a series of a mechanism that has the other sign than M.
  bool has_wrong_sign(const project::Operand& operand, std::vector<Issue>& issues) const;
};

std::unique_ptr<project::Step> make_motion_step(project::StepInput&& input);

}  // namespace loadpath::machine
