#include "lib/numerics/small_lu.hpp"

#include <algorithm>
#include <utility>

namespace loadpath::numerics {
namespace {

double larger(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

}  // namespace

bool SmallLu::factor_any() {
  if (size_ == 1) {
    inverse_ = 1.0 / a_[0];
    sign_ = std::copysign(1.0, a_[0]);
    return std::abs(a_[0]) > 0.0;
  }
  sign_ = 1.0;
  for (std::size_t r = 0; r < size_; ++r) {
    order_[r] = r;
    work_[r] = 0.0;
    columns_[r] = 0.0;
    for (std::size_t c = 0; c < size_; ++c) {
      work_[r] = larger(work_[r], at(r, c));
      columns_[r] = larger(columns_[r], at(c, r));
    }
  }
  for (std::size_t step = 0; step < size_; ++step) {
    if (!choose_pivot(step)) return false;
    const double inverse = 1.0 / at(step, step);
    for (std::size_t r = step + 1; r < size_; ++r) {
      const double factor = at(r, step) *= inverse;
      for (std::size_t c = step + 1; c < size_; ++c) at(r, c) -= factor * at(step, c);
    }
  }
  return true;
}

double SmallLu::determinant() const {
  if (size_ == 1 || size_ == 2) return 1.0 / inverse_;
  double product = 1.0;
  for (std::size_t k = 0; k < size_; ++k) product *= std::abs(a_[k * size_ + k]);
  return sign_ * product;
}

// Among the rows that are left, the largest against the scale that its row had: rows differ in their units.
bool SmallLu::choose_pivot(std::size_t step) {
  std::size_t best = step;
  for (std::size_t r = step + 1; r < size_; ++r) {
    if (std::abs(at(r, step)) * work_[best] > std::abs(at(best, step)) * work_[r]) best = r;
  }
  if (best != step) {
    std::swap_ranges(&at(step, 0), &at(step, 0) + size_, &at(best, 0));
    std::swap(work_[step], work_[best]);
    std::swap(order_[step], order_[best]);
    sign_ = -sign_;
  }
  sign_ = std::copysign(sign_, sign_ * at(step, step));
  return std::abs(at(step, step)) > rounding * columns_[step];
}

void SmallLu::solve_any(std::span<double> x) {
  if (size_ == 1) {
    x[0] *= inverse_;
  } else {
    for (std::size_t r = 0; r < size_; ++r) {
      work_[r] = x[order_[r]];
      for (std::size_t c = 0; c < r; ++c) work_[r] -= at(r, c) * work_[c];
    }
    for (std::size_t r = size_; r-- > 0;) {
      x[r] = work_[r];
      for (std::size_t c = r + 1; c < size_; ++c) x[r] -= at(r, c) * x[c];
      x[r] /= at(r, r);
    }
  }
}

void SmallLu::solve_any_transposed(std::span<double> x) {
  if (size_ == 1) {
    x[0] *= inverse_;
  } else {
    for (std::size_t r = 0; r < size_; ++r) {
      work_[r] = x[r];
      for (std::size_t c = 0; c < r; ++c) work_[r] -= at(c, r) * work_[c];
      work_[r] /= at(r, r);
    }
    for (std::size_t r = size_; r-- > 0;) {
      for (std::size_t c = r + 1; c < size_; ++c) work_[r] -= at(c, r) * work_[c];
      x[order_[r]] = work_[r];
    }
  }
}

}  // namespace loadpath::numerics
