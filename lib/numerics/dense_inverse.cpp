#include "lib/numerics/dense_inverse.hpp"

#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::numerics {
namespace {

using Row = std::span<double>;

/// The row at or below k that is largest in column k.
std::size_t pivot_row(std::span<const double> matrix, std::size_t size, std::size_t k) {
  std::size_t best = k;
  for (std::size_t i = k + 1; i < size; ++i) {
    if (std::abs(matrix[i * size + k]) > std::abs(matrix[best * size + k])) best = i;
  }
  return best;
}

/// row -= factor * by
void subtract(double factor, Row by, Row row) {
  for (std::size_t n = 0; n < row.size(); ++n) row[n] -= factor * by[n];
}

}  // namespace

void DenseInverse::invert(std::span<double> matrix) {
  const auto row = [&](std::size_t i) { return matrix.subspan(i * size_, size_); };
  for (std::size_t k = 0; k < size_; ++k) {
    exchanged_[k] = pivot_row(matrix, size_, k);
    if (exchanged_[k] != k) std::ranges::swap_ranges(row(k), row(exchanged_[k]));
    const Row own = row(k);
    const double inverse = 1.0 / own[k];
    own[k] = 1.0;
    for (double& x : own) x *= inverse;
    for (std::size_t i = 0; i < size_; ++i) {
      const double factor = i == k ? 0.0 : row(i)[k];
      if (factor == 0.0) continue;  // most of them: constraints are sparse
      row(i)[k] = 0.0;
      subtract(factor, own, row(i));
    }
  }
  for (std::size_t k = size_; k-- > 0;) {
    if (exchanged_[k] == k) continue;
    for (std::size_t i = 0; i < size_; ++i) std::swap(row(i)[k], row(i)[exchanged_[k]]);
  }
}

double largest_row_sum(std::span<const double> matrix, std::size_t size) {
  double most = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    double sum = 0.0;
    for (const double x : matrix.subspan(i * size, size)) sum += std::abs(x);
    most = larger_magnitude(most, sum);
  }
  return most;
}

}  // namespace loadpath::numerics
