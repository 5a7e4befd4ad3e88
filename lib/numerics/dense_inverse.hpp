// The inverse of a dense matrix of the size of a mechanism's constraints, where blocking would cost more than it saves;
// and how large the inverse of any matrix is, without it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::numerics {

class DenseInverse {
 public:
  explicit DenseInverse(std::size_t size) : size_(size), exchanged_(size) {}

  /// Replaces a square matrix of this size, by rows or by columns, by its inverse: Gauss-Jordan elimination with
  /// partial pivoting. The result of a singular matrix is not finite. Does not allocate.
  void invert(std::span<double> matrix);

 private:
  std::size_t size_;
  std::vector<std::size_t> exchanged_;  // with which row each was
};

/// The largest sum of magnitudes of a row, for matrices row after row; NaN if one is.
double largest_row_sum(std::span<const double> matrix, std::size_t size);

/// The 1-norm of A^-1, or slightly less: Hager's estimate, which climbs from corner to corner of the unit ball
/// (Higham, Accuracy and Stability of Numerical Algorithms, 15.2; recalled). `solve` and `solve_transposed` replace a
/// right side by the solution with A and with its transpose; `probe` is scratch of the matrix's size. NaN propagates.
template <class Solve, class SolveTransposed>
double estimated_inverse_norm(std::span<double> probe, Solve solve, SolveTransposed solve_transposed) {
  constexpr int most_climbs = 5;
  const auto magnitude = [](double x) { return std::abs(x); };
  std::ranges::fill(probe, 1.0 / static_cast<double>(probe.size()));
  double estimate = 0.0;
  std::size_t corner = probe.size();
  for (int climb = 0; climb < most_climbs; ++climb) {
    solve(probe);
    double size = 0.0;
    for (const double x : probe) size += std::abs(x);
    if (!std::isfinite(size)) return size;
    if (size <= estimate) break;
    estimate = size;
    for (double& x : probe) x = std::copysign(1.0, x);
    solve_transposed(probe);
    const auto next = static_cast<std::size_t>(std::ranges::max_element(probe, {}, magnitude) - probe.begin());
    if (next == corner) break;
    corner = next;
    std::ranges::fill(probe, 0.0);
    probe[corner] = 1.0;
  }
  return estimate;
}

}  // namespace loadpath::numerics
