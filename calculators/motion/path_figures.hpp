// The path of a point and its velocity and acceleration, drawn.
#pragma once

#include "calculators/motion/point_path.hpp"
#include "lib/figure/figure.hpp"

#include <string>
#include <utility>
#include <vector>

namespace loadpath::motion {

/// Vectors out of a pole, to one scale: velocities or accelerations of one time, in the plane xy.
struct Vectors {
  std::string title;
  std::string unit;
  std::vector<std::pair<std::string, figure::Point>> of;
};

/// A plot of a quantity over the time, its curves still to be drawn.
figure::Plot over_time(const char* symbol, const char* meaning, const char* unit);
/// A function of the time at `points` times from t_1 to t_2, their ends included.
template <class Function>
figure::Curve curve_over(double t_1, double t_2, int points, const char* label, const Function& value) {
  figure::Curve curve{label, {}, {}};
  for (int i = 0; i < points; ++i) {
    curve.x.push_back(t_1 + (t_2 - t_1) * i / (points - 1));
    curve.y.push_back(value(curve.x.back()));
  }
  return curve;
}

/// The path in the plane xy from t_1 to t_2 with the point at the time t.
figure::Figure path_figure(const PointPath& path, double t, double t_1, double t_2);
/// Speed, and the parts of the acceleration, over the range.
figure::Figure speed_figure(const PointPath& path, double t, double t_1, double t_2);
figure::Figure acceleration_figure(const PointPath& path, double t, double t_1, double t_2);
/// The plans of velocities and accelerations, next to each other.
figure::Figure plan_figure(const std::vector<Vectors>& panels);

}  // namespace loadpath::motion
