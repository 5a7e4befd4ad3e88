// LU factors of a square matrix with a constant pattern and changing values.
//
// The order of elimination is found once and kept as long as its pivots stay good; a pivot that has become poor brings
// a new order. All memory is taken in the constructor.
#pragma once

#include "lib/numerics/elimination_order.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::numerics {

class SparseLu {
 public:
  /// `pattern`: the places of possible nonzero values, each once.
  SparseLu(std::size_t size, std::span<const MatrixEntry> pattern);

  /// Factors the matrix with these values, in the order of the pattern. False when it is singular to rounding.
  [[nodiscard]] bool factor(std::span<const double> values);

  /// Forces a new ordering at the next matrix, as if it were the first.
  void forget_order() { ordered_ = false; }

  /// Replaces the right side by the solution of A x = b, or of A^T x = b.
  void solve(std::span<double> right);
  void solve_transposed(std::span<double> right);

  /// Estimate of 1 / (|A| |A^-1|) in the 1-norm for the values that were factored last.
  [[nodiscard]] double reciprocal_condition(std::span<const double> values);

 private:
  struct Rows {  // rows of a triangle, compressed
    std::vector<std::size_t> start, index;
    std::vector<double> value;
  };
  enum class Pivots { good, poor, vanished };

  Pivots refactor(std::span<const double> values);
  double load_row(std::size_t step, std::span<const double> values);
  void subtract_upper(std::size_t step);
  double scale_upper(std::size_t step, double inverse);
  void compile();
  void compile_source(std::size_t step);
  double norm(std::span<const double> values);

  std::size_t size_;
  std::vector<MatrixEntry> pattern_;
  EliminationOrder order_;
  bool ordered_ = false;
  std::vector<std::size_t> by_row_;  // the pattern's entries, sorted by row
  std::vector<std::size_t> row_start_;

  // A = L U with rows and columns numbered by the steps of the elimination; U has a unit diagonal.
  std::vector<std::size_t> source_start_, source_, source_column_;
  Rows lower_, upper_;
  std::vector<double> inverse_pivot_;
  std::vector<double> work_;  // all zero between calls
  std::vector<double> x_, probe_;
};

}  // namespace loadpath::numerics
