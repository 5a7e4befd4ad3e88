// The equation of the path of a point, by elimination of the time from two of its laws.
#pragma once

#include "calculators/motion/elimination/equation_text.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::motion {

/// One coordinate: its name in the equation, its law, which is not empty, and its values along the path, m.
struct PathCoordinate {
  std::string_view name;
  std::string_view law;
  std::vector<double> values;
};

struct PathEquation {
  CurveEquation curve;
  double deviation = 0.0;  // see deviation_of
};

/// The largest distance of the points from the curve of an equation, relative to their extent; NaN if the equation
/// cannot be evaluated at one of them.
double deviation_of(std::string_view equation, const PathCoordinate& x, const PathCoordinate& y);

/// The first equation that all points fulfil to rounding. `longest`: the largest magnitude of the times of the points.
PathEquation path_equation(const PathCoordinate& x, const PathCoordinate& y, double longest);

}  // namespace loadpath::motion
