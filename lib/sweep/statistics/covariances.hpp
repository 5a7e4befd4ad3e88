// The correlation of columns: covariances and correlations of each pair.
#pragma once

#include "lib/sweep/statistics/bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace loadpath::sweep {

/// Covariances over the points at which every column is finite. A part for a Forest.
class Covariances {
 public:
  Covariances() = default;
  /// The covariances of one block of n points.
  Covariances(std::span<const double* const> columns, std::size_t n);

  void merge(const Covariances& right);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] std::size_t size() const { return means_.size(); }
  [[nodiscard]] double mean(std::size_t i) const;
  [[nodiscard]] double covariance(std::size_t i, std::size_t j) const;
  /// NaN if one of the two does not vary.
  [[nodiscard]] double correlation(std::size_t i, std::size_t j) const;

  void store(Writer& writer) const;
  void load(Reader& reader);
  bool operator==(const Covariances&) const = default;

 private:
  [[nodiscard]] double product(std::size_t i, std::size_t j) const;

  std::uint64_t count_ = 0;
  std::vector<double> means_;
  std::vector<double> products_;  // products of deviations from the means: the lower triangle, row after row
};

}  // namespace loadpath::sweep
