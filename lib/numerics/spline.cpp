#include "lib/numerics/spline.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::numerics {

namespace {

/// The part of the x axis that an x between the first and the last lies in.
struct Part {
  std::size_t k = 1;  // its end
  double width = 0.0, t = 0.0;
};
Part part_at(const std::vector<double>& all, double x) {
  const auto next = std::upper_bound(all.begin() + 1, all.end() - 1, x);
  const auto k = static_cast<std::size_t>(next - all.begin());
  const double width = all[k] - all[k - 1];
  return {k, width, (x - all[k - 1]) / width};
}

}  // namespace

// The slopes at the points follow from equal second derivatives on both sides: a tridiagonal system, diagonally
// dominant, with zero at both ends.
RestToRestSpline::RestToRestSpline(std::span<const double> x, std::span<const double> y)
    : x_(x.begin(), x.end()), y_(y.begin(), y.end()), slope_(x.size()) {
  const std::size_t last = x_.size() - 1;
  std::vector<double> upper(x_.size());
  for (std::size_t k = 1; k < last; ++k) {
    const double before = 1.0 / (x_[k] - x_[k - 1]), after = 1.0 / (x_[k + 1] - x_[k]);
    const double right = 3.0 * ((y_[k] - y_[k - 1]) * before * before + (y_[k + 1] - y_[k]) * after * after);
    const double pivot = 1.0 / (2.0 * (before + after) - before * upper[k - 1]);
    upper[k] = after * pivot;
    slope_[k] = (right - before * slope_[k - 1]) * pivot;
  }
  for (std::size_t k = last; k-- > 1;) slope_[k] -= upper[k] * slope_[k + 1];
}

Jet RestToRestSpline::at(double x) const {
  if (x < x_.front()) return {y_.front()};
  if (x > x_.back()) return {y_.back()};
  const auto [k, width, t] = part_at(x_, x);
  const double rise = y_[k] - y_[k - 1], a = width * slope_[k - 1], b = width * slope_[k];
  const double square = 3.0 * rise - 2.0 * a - b, cube = a + b - 2.0 * rise;
  return {y_[k - 1] + t * (a + t * (square + t * cube)), (a + t * (2.0 * square + 3.0 * t * cube)) / width,
          (2.0 * square + 6.0 * t * cube) / (width * width)};
}

// Extremes between two points are where the derivative, a square polynomial, is zero.
RestToRestSpline::Overshoot RestToRestSpline::largest_overshoot() const {
  Overshoot largest;
  for (std::size_t k = 1; k < x_.size(); ++k) {
    const double width = x_[k] - x_[k - 1], rise = y_[k] - y_[k - 1];
    const double a = width * slope_[k - 1], b = width * slope_[k];
    const double square = 3.0 * rise - 2.0 * a - b, cube = a + b - 2.0 * rise;
    const double root = std::sqrt(std::max(0.0, square * square - 3.0 * cube * a));
    const double q = -(square + std::copysign(root, square));  // the root without cancellation, and the other from it
    for (const double t : {q / (3.0 * cube), a / q}) {
      if (!(t > 0.0 && t < 1.0)) continue;
      const double x = x_[k - 1] + t * width, y = at(x).value;
      const auto [low, high] = std::minmax(y_[k - 1], y_[k]);
      const double by = std::max(y - high, low - y);
      if (by > largest.by) largest = {x, y, by};
    }
  }
  return largest;
}

MonotoneSpline::MonotoneSpline(std::span<const double> x, std::span<const double> y)
    : x_(x.begin(), x.end()), y_(y.begin(), y.end()), slope_(x.size()) {
  for (std::size_t k = 1; k + 1 < x_.size(); ++k) {
    const double before = (y_[k] - y_[k - 1]) / (x_[k] - x_[k - 1]);
    const double after = (y_[k + 1] - y_[k]) / (x_[k + 1] - x_[k]);
    if (before * after > 0.0) slope_[k] = 2.0 / (1.0 / before + 1.0 / after);
  }
}

Jet MonotoneSpline::at(double x) const {
  if (x < x_.front()) return {y_.front()};
  if (x > x_.back()) return {y_.back()};
  const auto [k, width, t] = part_at(x_, x);
  const double rise = y_[k] - y_[k - 1], a = width * slope_[k - 1], b = width * slope_[k];
  const double c3 = 10.0 * rise - 6.0 * a - 4.0 * b, c4 = -15.0 * rise + 8.0 * a + 7.0 * b;
  const double c5 = 6.0 * rise - 3.0 * a - 3.0 * b;
  return {y_[k - 1] + t * (a + t * t * (c3 + t * (c4 + t * c5))),
          (a + t * t * (3.0 * c3 + t * (4.0 * c4 + t * 5.0 * c5))) / width,
          t * (6.0 * c3 + t * (12.0 * c4 + t * 20.0 * c5)) / (width * width)};
}

}  // namespace loadpath::numerics
