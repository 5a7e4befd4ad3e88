#include "lib/numerics/sparse_lu.hpp"

#include "lib/numerics/dense_inverse.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace loadpath::numerics {
namespace {

constexpr double poor_growth = 64.0;  // ratio of a row to its pivot
constexpr double negligible_pivot = 1e-13;

}  // namespace

SparseLu::SparseLu(std::size_t size, std::span<const MatrixEntry> pattern)
    : size_(size),
      pattern_(pattern.begin(), pattern.end()),
      order_(size),
      by_row_(pattern.size()),
      row_start_(size + 1),
      source_start_(size + 1),
      source_(pattern.size()),
      source_column_(pattern.size()),
      inverse_pivot_(size),
      work_(size),
      x_(size),
      probe_(size) {
  for (const auto& entry : pattern_) ++row_start_[static_cast<std::size_t>(entry.row) + 1];
  std::partial_sum(row_start_.begin(), row_start_.end(), row_start_.begin());
  std::iota(by_row_.begin(), by_row_.end(), std::size_t{0});
  std::ranges::stable_sort(by_row_, {}, [this](std::size_t k) { return pattern_[k].row; });
  for (Rows* rows : {&lower_, &upper_}) {
    rows->start.resize(size + 1);
    rows->index.reserve(size * size);
    rows->value.reserve(size * size);
  }
}

bool SparseLu::factor(std::span<const double> values) {
  assert(values.size() == pattern_.size());
  if (ordered_ && refactor(values) == Pivots::good) return true;
  ordered_ = order_.find(pattern_, values);
  if (!ordered_) return false;
  compile();
  return refactor(values) != Pivots::vanished;
}

SparseLu::Pivots SparseLu::refactor(std::span<const double> values) {
  double growth = 0.0;
  for (std::size_t step = 0; step < size_; ++step) {
    const double largest = load_row(step, values);
    subtract_upper(step);
    const double pivot = work_[step];
    work_[step] = 0.0;
    if (!(std::abs(pivot) > negligible_pivot * largest)) {
      std::ranges::fill(work_, 0.0);
      return Pivots::vanished;
    }
    inverse_pivot_[step] = 1.0 / pivot;
    growth = std::max(growth, scale_upper(step, inverse_pivot_[step]));
  }
  return growth <= poor_growth ? Pivots::good : Pivots::poor;
}

inline double SparseLu::load_row(std::size_t step, std::span<const double> values) {
  double largest = 0.0;
  for (std::size_t k = source_start_[step]; k < source_start_[step + 1]; ++k) {
    work_[source_column_[k]] = values[source_[k]];
    largest = std::max(largest, std::abs(values[source_[k]]));
  }
  return largest;
}

inline void SparseLu::subtract_upper(std::size_t step) {
  for (std::size_t k = lower_.start[step]; k < lower_.start[step + 1]; ++k) {
    const std::size_t above = lower_.index[k];
    const double factor = work_[above];
    lower_.value[k] = factor;
    work_[above] = 0.0;
    for (std::size_t u = upper_.start[above]; u < upper_.start[above + 1]; ++u) {
      work_[upper_.index[u]] -= factor * upper_.value[u];
    }
  }
}

inline double SparseLu::scale_upper(std::size_t step, double inverse) {
  double largest = 0.0;
  for (std::size_t u = upper_.start[step]; u < upper_.start[step + 1]; ++u) {
    double& value = work_[upper_.index[u]];
    upper_.value[u] = value * inverse;
    largest = std::max(largest, std::abs(upper_.value[u]));
    value = 0.0;
  }
  return largest;
}

void SparseLu::compile() {
  lower_.index.clear();
  upper_.index.clear();
  for (std::size_t step = 0; step < size_; ++step) {
    compile_source(step);
    const auto subtracted = order_.subtracted(step);
    lower_.index.insert(lower_.index.end(), subtracted.begin(), subtracted.end());
    for (const auto column : order_.kept_columns(step)) {
      if (column != order_.column(step)) upper_.index.push_back(order_.step_of_column(column));
    }
    lower_.start[step + 1] = lower_.index.size();
    upper_.start[step + 1] = upper_.index.size();
  }
  lower_.value.resize(lower_.index.size());
  upper_.value.resize(upper_.index.size());
}

void SparseLu::compile_source(std::size_t step) {
  const std::size_t row = order_.row(step);
  std::size_t next = source_start_[step];
  for (std::size_t k = row_start_[row]; k < row_start_[row + 1]; ++k, ++next) {
    source_[next] = by_row_[k];
    source_column_[next] = order_.step_of_column(static_cast<std::size_t>(pattern_[by_row_[k]].column));
  }
  source_start_[step + 1] = next;
}

void SparseLu::solve(std::span<double> right) {
  for (std::size_t step = 0; step < size_; ++step) {
    double sum = right[order_.row(step)];
    for (std::size_t k = lower_.start[step]; k < lower_.start[step + 1]; ++k) {
      sum -= lower_.value[k] * x_[lower_.index[k]];
    }
    x_[step] = sum * inverse_pivot_[step];
  }
  for (std::size_t step = size_; step-- > 0;) {
    double sum = x_[step];
    for (std::size_t k = upper_.start[step]; k < upper_.start[step + 1]; ++k) {
      sum -= upper_.value[k] * x_[upper_.index[k]];
    }
    x_[step] = sum;
    right[order_.column(step)] = sum;
  }
}

void SparseLu::solve_transposed(std::span<double> right) {
  for (std::size_t step = 0; step < size_; ++step) x_[step] = right[order_.column(step)];
  for (std::size_t step = 0; step < size_; ++step) {
    for (std::size_t k = upper_.start[step]; k < upper_.start[step + 1]; ++k) {
      x_[upper_.index[k]] -= upper_.value[k] * x_[step];
    }
  }
  for (std::size_t step = size_; step-- > 0;) {
    x_[step] *= inverse_pivot_[step];
    for (std::size_t k = lower_.start[step]; k < lower_.start[step + 1]; ++k) {
      x_[lower_.index[k]] -= lower_.value[k] * x_[step];
    }
    right[order_.row(step)] = x_[step];
  }
}

double SparseLu::reciprocal_condition(std::span<const double> values) {
  if (size_ == 0) return 1.0;
  const double norm_of_inverse = estimated_inverse_norm(
      probe_, [this](std::span<double> right) { solve(right); },
      [this](std::span<double> right) { solve_transposed(right); });
  return 1.0 / (norm(values) * norm_of_inverse);
}

double SparseLu::norm(std::span<const double> values) {
  std::ranges::fill(probe_, 0.0);
  for (std::size_t k = 0; k < pattern_.size(); ++k) {
    probe_[static_cast<std::size_t>(pattern_[k].column)] += std::abs(values[k]);
  }
  return *std::ranges::max_element(probe_);
}

}  // namespace loadpath::numerics
