#include "lib/numerics/elimination_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::numerics {
namespace {

constexpr double smallest_ratio = 0.25;  // ratio of a pivot to the largest value in its row
constexpr double rounding = 1e-13;

}  // namespace

EliminationOrder::EliminationOrder(std::size_t size)
    : size_(size),
      row_(size),
      column_(size),
      step_of_column_(size),
      rows_(size),
      entries_in_column_(size),
      value_(size * size),
      occupied_(size * size),
      columns_(size * size),
      subtracted_(size * size) {}

std::span<const std::size_t> EliminationOrder::subtracted(std::size_t step) const {
  return std::span(subtracted_).subspan(row_[step] * size_, rows_[row_[step]].subtracted);
}

std::span<const std::size_t> EliminationOrder::kept_columns(std::size_t step) const {
  return std::span(columns_).subspan(row_[step] * size_, rows_[row_[step]].columns);
}

bool EliminationOrder::find(std::span<const MatrixEntry> pattern, std::span<const double> values) {
  load(pattern, values);
  for (std::size_t step = 0; step < size_; ++step) {
    if (!choose_pivot(step)) return false;
    eliminate(step);
  }
  return true;
}

void EliminationOrder::load(std::span<const MatrixEntry> pattern, std::span<const double> values) {
  std::ranges::fill(value_, 0.0);
  std::ranges::fill(occupied_, char{0});
  std::ranges::fill(rows_, Row{});
  std::ranges::fill(entries_in_column_, std::size_t{0});
  for (std::size_t k = 0; k < pattern.size(); ++k) {
    const auto row = static_cast<std::size_t>(pattern[k].row);
    const auto column = static_cast<std::size_t>(pattern[k].column);
    at(row, column) = values[k];
    rows_[row].scale = std::max(rows_[row].scale, std::abs(values[k]));
    occupied_[row * size_ + column] = 1;
    columns_[row * size_ + rows_[row].columns++] = column;
    ++entries_in_column_[column];
  }
}

bool EliminationOrder::choose_pivot(std::size_t step) {
  std::size_t least_fill = std::numeric_limits<std::size_t>::max();
  double best_ratio = 0.0;
  for (std::size_t row = 0; row < size_; ++row) {
    if (rows_[row].done) continue;
    const auto columns = std::span(columns_).subspan(row * size_, rows_[row].columns);
    double largest = 0.0;
    for (const auto column : columns) largest = std::max(largest, std::abs(at(row, column)));
    if (!(largest > rounding * rows_[row].scale)) return false;
    for (const auto column : columns) {
      const double ratio = std::abs(at(row, column)) / largest;
      const std::size_t fill = (columns.size() - 1) * (entries_in_column_[column] - 1);
      if (ratio < smallest_ratio || fill > least_fill || (fill == least_fill && ratio <= best_ratio)) continue;
      least_fill = fill;
      best_ratio = ratio;
      row_[step] = row;
      column_[step] = column;
    }
  }
  return best_ratio > 0.0;
}

void EliminationOrder::eliminate(std::size_t step) {
  rows_[row_[step]].done = true;
  step_of_column_[column_[step]] = step;
  for (const auto column : kept_columns(step)) --entries_in_column_[column];
  for (std::size_t row = 0; row < size_; ++row) {
    if (!rows_[row].done && occupied_[row * size_ + column_[step]]) subtract(row, step);
  }
}

void EliminationOrder::subtract(std::size_t row, std::size_t step) {
  Row& mine = rows_[row];
  std::size_t* const columns = &columns_[row * size_];
  subtracted_[row * size_ + mine.subtracted++] = step;
  *std::find(columns, columns + mine.columns, column_[step]) = columns[mine.columns - 1];
  --mine.columns;
  const double factor = at(row, column_[step]) / at(row_[step], column_[step]);
  for (const auto column : kept_columns(step)) {
    if (column == column_[step]) continue;
    at(row, column) -= factor * at(row_[step], column);
    char& occupied = occupied_[row * size_ + column];
    if (occupied) continue;
    occupied = 1;
    columns[mine.columns++] = column;
    ++entries_in_column_[column];
  }
}

}  // namespace loadpath::numerics
