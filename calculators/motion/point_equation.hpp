// The limits of a path over a range of time, and its equation without the time.
#pragma once

#include "calculators/motion/elimination/path_equation.hpp"
#include "calculators/motion/point_path.hpp"

#include <array>

namespace loadpath::motion {

/// The smallest and the largest value of each coordinate, m.
struct PathLimits {
  std::array<double, 3> low{}, high{};
};
PathLimits limits_of(const PointPath& path, double t_1, double t_2);

/// In the plane xy, and for a path in space a second one of z with x, or with y where x is constant.
struct PathEquations {
  PathEquation plane, space;
};
PathEquations equations_of(const PointPath& path, double t_1, double t_2);

}  // namespace loadpath::motion
