// A step whose every input is one value, for many points at once, without a word: its calculator's kernel over columns.
//
// It knows the ordinary course of things: every input has a value, every rule holds, every check is there. A point
// where that is not so is told to be another's, who solves it as a machine of its own.
#pragma once

#include "lib/project/project.hpp"
#include "lib/project/run/calculator_step.hpp"
#include "lib/project/sweep/loops.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace loadpath::project {

/// Columns of values by their full paths, and which points are out of the ordinary.
struct PointColumns {
  std::size_t count = 0;
  std::map<std::string, std::vector<double>, std::less<>> values;
  std::map<std::string, double, std::less<>> constants;  // what is the same at every point
  std::vector<char> is_other;

  /// The values of a path, NaN where it has none.
  const double* of(const std::string& path);
};

class ColumnStep {
 public:
  /// Of a step that was solved at one point; null where the step needs more than its kernel. `wanted`: full
  /// paths of its values that others refer to.
  static std::unique_ptr<ColumnStep> of(CalculatorStep& step, const std::set<std::string>& wanted);
  ~ColumnStep();

  /// Takes its inputs from the columns, adds its values to them, and says how its modes came out, in the order of the
  /// calculator.
  void evaluate(PointColumns& points, std::vector<ModeColumns>& modes);

 private:
  struct Parts;
  explicit ColumnStep(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace loadpath::project
