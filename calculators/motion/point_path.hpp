// The motion of a point by laws of its coordinates: states at times, and what holds over a range of time. SI numbers.
#pragma once

#include "calculators/motion/laws.hpp"

#include <array>

namespace loadpath::motion {

/// Place, velocity and acceleration, with the parts along the path.
struct PointState {
  std::array<double, 3> r{}, v{}, a{};
  double speed = 0.0;                          // m/s; zero where it is nothing but rounding
  double acceleration = 0.0;                   // m/s^2
  double a_tau = 0.0, a_n = 0.0, kappa = 0.0;  // NaN where the point rests: there is no tangent
};

/// Motion of a point as given by an input; an empty formula is a coordinate that stays zero.
struct PointPath {
  Written x, y, z;

  PointPath(const LengthLaw& x_of_t, const LengthLaw& y_of_t, const LengthLaw& z_of_t)
      : x{"x", &x_of_t}, y{"y", &y_of_t}, z{"z", &z_of_t} {}

  [[nodiscard]] std::array<Written, 3> all() const { return {x, y, z}; }
  [[nodiscard]] FieldFault reading_fault() const { return motion::reading_fault(all()); }
  [[nodiscard]] FieldFault gap_fault(double t_1, double t_2) const { return motion::gap_fault(all(), t_1, t_2); }

  [[nodiscard]] PointState at(double t) const;
  /// The path length from t_1 to t_2, with both directions of a return counted, m.
  [[nodiscard]] double length(double t_1, double t_2) const;
};

}  // namespace loadpath::motion
