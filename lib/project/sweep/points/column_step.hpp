// A calculator's step at many points at once, without a word: the kernel over columns of points, or of the positions of
// all points where loads are series.
//
// It handles regular points: every input has a value, every rule is satisfied, every check exists. An irregular point
// is handed over, to be solved as a separate design.
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
  /// For a step that was solved at one point; null if the step needs more than its kernel. `wanted`: full paths of
  /// its values that others refer to. `points`: with the signatures of the values it refers to.
  static std::unique_ptr<ColumnStep> of(CalculatorStep& step, const std::set<std::string>& wanted,
                                        const PointColumns& points);
  ~ColumnStep() override;

  void evaluate(PointColumns& points, std::vector<account::ModeColumns>& modes) override;
  /// Whether it searches for this size.
  [[nodiscard]] bool seeks(const std::string& path) const;
  /// The least size at each point, which other steps of the same body require; 0 and none at all: any.
  void keep_to(std::vector<double> least);

 private:
  explicit ColumnStep(std::unique_ptr<ColumnParts> parts);

  std::unique_ptr<ColumnParts> parts_;
};

}  // namespace loadpath::project
