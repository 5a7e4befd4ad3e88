// The cubic spline through given points that starts and ends at rest: its second derivative is continuous.
#pragma once

#include <span>
#include <vector>

namespace loadpath {

class RestToRestSpline {
 public:
  /// Two points or more, x strictly ascending.
  RestToRestSpline(std::span<const double> x, std::span<const double> y);

  struct Value {
    double y = 0.0, first = 0.0, second = 0.0;  // and its derivatives
  };
  /// Before the first point and after the last it rests.
  [[nodiscard]] Value at(double x) const;

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace loadpath
