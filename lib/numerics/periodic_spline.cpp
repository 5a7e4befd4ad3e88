#include "lib/numerics/periodic_spline.hpp"

#include "lib/numerics/dual.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace loadpath::numerics {

// The second derivatives at the points follow from equal slopes on both sides: a cyclic tridiagonal system, diagonally
// dominant.
PeriodicSpline::PeriodicSpline(std::span<const double> x, std::span<const double> y, double period)
    : x_(x.begin(), x.end()), y_(y.begin(), y.end()) {
  x_.push_back(x_.front() + period);
  y_.push_back(y_.front());
  const std::size_t count = x.size();
  const auto size = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd left = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right(size);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t back = (k + count - 1) % count, on = (k + 1) % count;
    const double before = x_[back + 1] - x_[back], after = x_[k + 1] - x_[k];
    const auto row = static_cast<Eigen::Index>(k);
    left(row, static_cast<Eigen::Index>(back)) += before;
    left(row, row) += 2.0 * (before + after);
    left(row, static_cast<Eigen::Index>(on)) += after;
    right(row) = 6.0 * ((y_[k + 1] - y_[k]) / after - (y_[back + 1] - y_[back]) / before);
  }
  const Eigen::VectorXd found = left.partialPivLu().solve(right);
  second_.assign(found.begin(), found.end());
  second_.push_back(second_.front());
}

template <class Scalar>
PeriodicSpline::Value<Scalar> PeriodicSpline::at(Scalar x) const {
  const double period = x_.back() - x_.front();
  const Scalar within = x - period * std::floor((value_of(x) - x_.front()) / period);
  const auto next = std::upper_bound(x_.begin() + 1, x_.end() - 1, value_of(within));
  const auto k = static_cast<std::size_t>(next - x_.begin());
  const double width = x_[k] - x_[k - 1];
  const Scalar b = (within - x_[k - 1]) / width, a = 1.0 - b;
  const double m_a = second_[k - 1], m_b = second_[k];
  const double part = width * width / 6.0;
  return {a * y_[k - 1] + b * y_[k] + part * ((a * a * a - a) * m_a + (b * b * b - b) * m_b),
          (y_[k] - y_[k - 1]) / width + width / 6.0 * ((3.0 * b * b - 1.0) * m_b - (3.0 * a * a - 1.0) * m_a),
          a * m_a + b * m_b};
}

template PeriodicSpline::Value<double> PeriodicSpline::at(double) const;
template PeriodicSpline::Value<Dual> PeriodicSpline::at(Dual) const;

}  // namespace loadpath::numerics
