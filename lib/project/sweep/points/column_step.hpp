// A calculator's step at many points at once, without a word: the kernel over columns of points, or of the positions of
// all points where loads are series.
//
// It knows the ordinary course of things: every input has a value, every rule holds, every check is there. A point
// where that is not so is told to be another's, who solves it as a machine of its own.
#pragma once

#include "lib/project/run/calculator_step.hpp"
#include "lib/project/sweep/points/point_step.hpp"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

struct ColumnParts;

class ColumnStep final : public PointStep {
 public:
  /// Of a step that was solved at one point; null where the step needs more than its kernel. `wanted`: full
  /// paths of its values that others refer to. `points`: with the signatures of what it refers to.
  static std::unique_ptr<ColumnStep> of(CalculatorStep& step, const std::set<std::string>& wanted,
                                        const PointColumns& points);
  ~ColumnStep() override;

  void evaluate(PointColumns& points, std::vector<account::ModeColumns>& modes) override;

 private:
  explicit ColumnStep(std::unique_ptr<ColumnParts> parts);

  std::unique_ptr<ColumnParts> parts_;
};

}  // namespace loadpath::project
