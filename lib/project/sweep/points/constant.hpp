// A step that no varied input of a sweep affects: its values and states at one point are those of every point.
#pragma once

#include "lib/project/step.hpp"
#include "lib/project/sweep/points/point_step.hpp"

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::project {

class ConstantStep final : public PointStep {
 public:
  /// For a step that was solved at one point; its values are marked as those of every point. `referred`: full paths of
  /// values that expressions refer to. Null if a mode is not of its calculator: a missing input.
  static std::unique_ptr<ConstantStep> of(const Step& step, const std::set<std::string>& referred,
                                          PointColumns& points);

  void evaluate(PointColumns& points, std::vector<account::ModeColumns>& modes) override;

 private:
  std::vector<account::Judged> states_;  // of each mode
  std::vector<std::pair<std::string, Value>> series_;
};

}  // namespace loadpath::project
