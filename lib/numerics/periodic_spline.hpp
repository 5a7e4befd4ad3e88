// The closed cubic spline through given points: its second derivative is continuous all round.
#pragma once

#include <span>
#include <vector>

namespace loadpath::numerics {

class PeriodicSpline {
 public:
  /// Values at x strictly ascending, three or more; the first comes again at `period` beyond the first x.
  PeriodicSpline(std::span<const double> x, std::span<const double> y, double period);

  template <class Scalar>
  struct Value {
    Scalar y = 0.0, first = 0.0, second = 0.0;  // and its derivatives
  };
  /// Anywhere, a period on or back too.
  template <class Scalar>
  [[nodiscard]] Value<Scalar> at(Scalar x) const;

 private:
  std::vector<double> x_, y_, second_;  // with the first point again at the end
};

}  // namespace loadpath::numerics
