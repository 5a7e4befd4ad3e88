// LU factors of a small dense matrix; all memory is taken in the constructor. Sizes 1 and 2, the most frequent ones
// for a mechanism's groups, use their determinant.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::numerics {

class SmallLu {
 public:
  explicit SmallLu(std::size_t size) : size_(size), a_(size * size), order_(size), work_(size), columns_(size) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double& at(std::size_t row, std::size_t column) { return a_[row * size_ + column]; }

  void clear() { std::fill(a_.begin(), a_.end(), 0.0); }
  /// Factors the matrix that was filled in. False if it is singular: a column differs from a combination of the
  /// others by less than 1e-7 of its size.
  [[nodiscard]] bool factor() { return size_ == 2 ? factor_two() : factor_any(); }
  /// +1 or -1: the sign of the determinant of the factored matrix.
  [[nodiscard]] double sign() const { return sign_; }
  /// The determinant of the matrix, if `factor` has accepted it.
  [[nodiscard]] double determinant() const;
  /// Replaces the right side by the solution of A x = b, or of A^T x = b.
  void solve(std::span<double> right) { size_ == 2 ? solve_two(right, a_[1], a_[2]) : solve_any(right); }
  void solve_transposed(std::span<double> right) {
    size_ == 2 ? solve_two(right, a_[2], a_[1]) : solve_any_transposed(right);
  }

 private:
  bool factor_two();
  void solve_two(std::span<double> x, double right_of_first, double below_first) const {
    const double first = x[0];
    x[0] = inverse_ * (a_[3] * first - right_of_first * x[1]);
    x[1] = inverse_ * (a_[0] * x[1] - below_first * first);
  }
  bool factor_any();
  void solve_any(std::span<double> right);
  void solve_any_transposed(std::span<double> right);
  [[nodiscard]] bool choose_pivot(std::size_t step);

  std::size_t size_;
  std::vector<double> a_;
  std::vector<std::size_t> order_;
  std::vector<double> work_;     // the rows' scales while factoring; the right side while solving
  std::vector<double> columns_;  // their scales
  double inverse_ = 0.0;         // inverse of the determinant, sizes 1 and 2
  double sign_ = 1.0;
  // Threshold of a pivot relative to the largest of its column: the remaining effect of a coordinate once the others
  // have compensated for it. Near a double root, iteration converges to only half of the digits, and within that
  // distance the two roots cannot be separated.
  static constexpr double rounding = 1e-7;
};

inline bool SmallLu::factor_two() {
  const double determinant = a_[0] * a_[3] - a_[1] * a_[2];
  inverse_ = 1.0 / determinant;
  sign_ = std::copysign(1.0, determinant);
  const double first = a_[0] * a_[0] + a_[2] * a_[2], second = a_[1] * a_[1] + a_[3] * a_[3];
  return determinant * determinant > rounding * rounding * first * second;
}

}  // namespace loadpath::numerics
