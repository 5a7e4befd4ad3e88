#include "lib/sweep/statistics/covariances.hpp"

#include "lib/simd/attributes.hpp"
#include "lib/sweep/nan.hpp"
#include "lib/sweep/statistics/lanes.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::sweep {

namespace {

LOADPATH_COLUMNS double sum_from(double from, const double* x, std::size_t n) {
  Lanes sum{};
  in_lanes(n, [&](std::size_t i, std::size_t lane) { sum[lane] += x[i] - from; });
  return sum_of(sum);
}

LOADPATH_COLUMNS double product_of(const double* x, const double* y, std::size_t n) {
  Lanes sum{};
  in_lanes(n, [&](std::size_t i, std::size_t lane) { sum[lane] += x[i] * y[i]; });
  return sum_of(sum);
}

/// The points at which every column is finite, column after column.
std::vector<std::vector<double>> complete(std::span<const double* const> columns, std::size_t n) {
  std::vector<std::vector<double>> kept(columns.size());
  if (std::all_of(columns.begin(), columns.end(), [&](const double* x) { return all_finite({x, n}); })) {
    for (std::size_t k = 0; k < columns.size(); ++k) kept[k].assign(columns[k], columns[k] + n);
    return kept;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::all_of(columns.begin(), columns.end(), [&](const double* x) { return is_finite(x[i]); })) continue;
    for (std::size_t k = 0; k < columns.size(); ++k) kept[k].push_back(columns[k][i]);
  }
  return kept;
}

}  // namespace

Covariances::Covariances(std::span<const double* const> columns, std::size_t n)
    : means_(columns.size()), products_(columns.size() * (columns.size() + 1) / 2) {
  auto away = complete(columns, n);
  count_ = away.empty() ? 0 : away.front().size();
  if (count_ == 0) return;
  double* product = products_.data();
  for (std::size_t i = 0; i < away.size(); ++i) {
    auto& x = away[i];
    means_[i] = x.front() + sum_from(x.front(), x.data(), x.size()) / static_cast<double>(count_);
    for (double& value : x) value -= means_[i];
    for (std::size_t j = 0; j <= i; ++j) *product++ = product_of(x.data(), away[j].data(), x.size());
  }
}

void Covariances::merge(const Covariances& right) {
  if (right.count_ == 0) return;
  if (count_ == 0) {
    *this = right;
    return;
  }
  const auto a = static_cast<double>(count_), b = static_cast<double>(right.count_);
  const double n = a + b;
  std::size_t at = 0;
  for (std::size_t i = 0; i < means_.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j, ++at) {
      const double both = (right.means_[i] - means_[i]) * (right.means_[j] - means_[j]);
      products_[at] += right.products_[at] + both * (a * b / n);
    }
  }
  for (std::size_t i = 0; i < means_.size(); ++i) means_[i] += (right.means_[i] - means_[i]) * (b / n);
  count_ += right.count_;
}

double Covariances::product(std::size_t i, std::size_t j) const {
  const std::size_t row = std::max(i, j), column = std::min(i, j);
  return products_[row * (row + 1) / 2 + column];
}

double Covariances::mean(std::size_t i) const { return count_ > 0 ? means_[i] : nan; }

double Covariances::covariance(std::size_t i, std::size_t j) const {
  return count_ > 1 ? product(i, j) / static_cast<double>(count_ - 1) : nan;
}

double Covariances::correlation(std::size_t i, std::size_t j) const {
  if (count_ < 2 || !(product(i, i) > 0.0) || !(product(j, j) > 0.0)) return nan;
  return std::clamp(product(i, j) / (std::sqrt(product(i, i)) * std::sqrt(product(j, j))), -1.0, 1.0);
}

void Covariances::store(Writer& writer) const {
  writer.put(count_);
  writer.put(std::uint64_t{means_.size()});
  for (const double mean : means_) writer.put(mean);
  for (const double product : products_) writer.put(product);
}

void Covariances::load(Reader& reader) {
  count_ = reader.number();
  const std::uint64_t size = reader.count(1), products = size < (1 << 20) ? size * (size + 1) / 2 : ~std::uint64_t{0};
  means_.clear();
  products_.clear();
  if (!reader.has(products)) {
    reader.fail();
    return;
  }
  means_.resize(size);
  products_.resize(products);
  for (double& mean : means_) mean = reader.real();
  for (double& product : products_) product = reader.real();
}

}  // namespace loadpath::sweep
