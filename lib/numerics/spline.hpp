// Curves through given points that start and end at rest, with continuous second derivatives.
#pragma once

#include "lib/numerics/jet.hpp"

#include <span>
#include <vector>

namespace loadpath::numerics {

/// The cubic spline: smooth, but it may overshoot beyond its points.
class RestToRestSpline {
 public:
  /// Two points or more, x strictly ascending.
  RestToRestSpline(std::span<const double> x, std::span<const double> y);

  /// Before the first point and after the last it rests.
  [[nodiscard]] Jet at(double x) const;

  /// The location of an overshoot beyond the two adjacent points, and its amount.
  struct Overshoot {
    double x = 0.0, y = 0.0, by = 0.0;
  };
  /// The largest; 0 if there is none.
  [[nodiscard]] Overshoot largest_overshoot() const;

 private:
  std::vector<double> x_, y_, slope_;
};

/// Polynomials of the fifth degree that rise where the points rise, fall where they fall and rest where they turn or
/// dwell: never beyond the points. The second derivative is zero at each of them, the slope between points that rise or
/// fall the harmonic mean of those on its sides, and so at most twice either of them. That keeps the curve monotone:
/// its slope is linear in the slopes at both ends of a part, and for 0 and 2 of the part's own in any combination it is
/// 30 u^2 (1 - u)^2, 2 - 30 u^2 (1 - u)^2 >= 1/8, or of no negative coefficient in Bernstein's form.
class MonotoneSpline {
 public:
  /// Two points or more, x strictly ascending.
  MonotoneSpline(std::span<const double> x, std::span<const double> y);
  /// Before the first point and after the last it rests.
  [[nodiscard]] Jet at(double x) const;

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace loadpath::numerics
