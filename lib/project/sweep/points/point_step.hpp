// A step of a project at many points at once.
#pragma once

#include "lib/account/fold.hpp"
#include "lib/project/sweep/points/point_columns.hpp"

#include <vector>

namespace loadpath::project {

class PointStep {
 public:
  virtual ~PointStep() = default;

  /// Takes its inputs from the columns, adds its values to them, and says how its modes came out, in the order of the
  /// calculator. A point where things do not take their ordinary course is told to be another's, who solves it as a
  /// machine of its own.
  virtual void evaluate(PointColumns& points, std::vector<account::ModeColumns>& modes) = 0;
  /// Whether it looks at the axes of others' series, how fast they run, and not at the places of the numbers alone.
  [[nodiscard]] virtual bool reads_axes() const { return false; }
};

}  // namespace loadpath::project
