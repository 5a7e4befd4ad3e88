// A step of a project at many points at once.
#pragma once

#include "lib/account/fold.hpp"
#include "lib/project/sweep/points/point_columns.hpp"

#include <vector>

namespace loadpath::project {

class PointStep {
 public:
  virtual ~PointStep() = default;

  /// Takes its inputs from the columns, adds its values to them, and sets the states of its modes, in the order of
  /// the calculator. An irregular point is handed over, to be solved as a separate design.
  virtual void evaluate(PointColumns& points, std::vector<account::ModeColumns>& modes) = 0;
  /// Whether it uses the axes of other steps' series and their speeds, not only the positions of the numbers.
  [[nodiscard]] virtual bool reads_axes() const { return false; }
};

}  // namespace loadpath::project
