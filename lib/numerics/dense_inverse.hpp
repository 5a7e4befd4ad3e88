// The inverse of a dense matrix of the size of a mechanism's constraints, where blocking would cost more than it saves.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath {

class DenseInverse {
 public:
  explicit DenseInverse(std::size_t size) : size_(size), exchanged_(size) {}

  /// Replaces a square matrix of this size, row after row, or column after column, by its inverse: Gauss-Jordan
  /// elimination with partial pivoting. Of a singular matrix it holds no finite numbers. Takes no memory.
  void invert(std::span<double> matrix);

 private:
  std::size_t size_;
  std::vector<std::size_t> exchanged_;  // with which row each was
};

/// The largest sum of magnitudes of a row, for matrices row after row; NaN where one is.
double largest_row_sum(std::span<const double> matrix, std::size_t size);

}  // namespace loadpath
