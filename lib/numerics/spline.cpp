#include "lib/numerics/spline.hpp"

#include <algorithm>

namespace loadpath {

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

RestToRestSpline::Value RestToRestSpline::at(double x) const {
  if (x < x_.front()) return {y_.front(), 0.0, 0.0};
  if (x > x_.back()) return {y_.back(), 0.0, 0.0};
  const auto next = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto k = static_cast<std::size_t>(next - x_.begin());
  const double width = x_[k] - x_[k - 1], t = (x - x_[k - 1]) / width;
  const double rise = y_[k] - y_[k - 1], a = width * slope_[k - 1], b = width * slope_[k];
  const double square = 3.0 * rise - 2.0 * a - b, cube = a + b - 2.0 * rise;
  return {y_[k - 1] + t * (a + t * (square + t * cube)), (a + t * (2.0 * square + 3.0 * t * cube)) / width,
          (2.0 * square + 6.0 * t * cube) / (width * width)};
}

}  // namespace loadpath
