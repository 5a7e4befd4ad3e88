// A curve on the page: cut where values are missing, thinned, with the stretches of one value found.
#pragma once

#include "lib/draw/plot/frame.hpp"

#include <vector>

namespace loadpath::draw {

/// A stretch along which the value does not change.
struct Level {
  Point from, to;
  double si = 0.0;
};

struct DrawnCurve {
  std::vector<std::vector<Point>> pieces;
  std::vector<Level> levels;  // levels of a filled curve only
};

DrawnCurve drawn_curve(const figure::Curve& curve, const PlotFrame& frame);

}  // namespace loadpath::draw
