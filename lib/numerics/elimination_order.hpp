// The order in which a sparse matrix is eliminated: Markowitz' least fill-in among the pivots that are large enough.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::numerics {

struct MatrixEntry {
  int row;
  int column;
};

class EliminationOrder {
 public:
  explicit EliminationOrder(std::size_t size);

  /// False when no pivot is left that differs from zero by more than rounding. Allocates nothing.
  [[nodiscard]] bool find(std::span<const MatrixEntry> pattern, std::span<const double> values);

  [[nodiscard]] std::size_t row(std::size_t step) const { return row_[step]; }
  [[nodiscard]] std::size_t column(std::size_t step) const { return column_[step]; }
  [[nodiscard]] std::size_t step_of_column(std::size_t column) const { return step_of_column_[column]; }
  /// The earlier steps that were subtracted from the pivot row of this step, and the columns it kept, pivot included.
  [[nodiscard]] std::span<const std::size_t> subtracted(std::size_t step) const;
  [[nodiscard]] std::span<const std::size_t> kept_columns(std::size_t step) const;

 private:
  struct Row {
    bool done = false;
    double scale = 0.0;  // its largest value before the elimination
    std::size_t columns = 0;
    std::size_t subtracted = 0;
  };

  void load(std::span<const MatrixEntry> pattern, std::span<const double> values);
  bool choose_pivot(std::size_t step);
  void eliminate(std::size_t step);
  void subtract(std::size_t row, std::size_t step);
  double& at(std::size_t row, std::size_t column) { return value_[row * size_ + column]; }

  std::size_t size_;
  std::vector<std::size_t> row_, column_, step_of_column_;
  std::vector<Row> rows_;
  std::vector<std::size_t> entries_in_column_;
  std::vector<double> value_;  // dense, as the lists below: size * size
  std::vector<char> occupied_;
  std::vector<std::size_t> columns_, subtracted_;
};

}  // namespace loadpath::numerics
