// Mean, variance, skewness and kurtosis of columns that come in blocks: Chan, Golub and LeVeque 1979 and, for the
// higher moments, Pebay 2008 (SAND2008-6212).
#pragma once

#include "lib/sweep/statistics/bytes.hpp"

#include <cstdint>
#include <span>

namespace loadpath::sweep {

/// Infinite values and NaN are not counted. Undefined moments, like the variance of one value, are NaN.
class Moments {
 public:
  Moments() = default;
  /// The moments of one block, in two passes over it.
  explicit Moments(std::span<const double> values);
  /// The same, where the number of finite values, one of them and the sum of their distances from it are known.
  Moments(std::span<const double> values, std::uint64_t count, double from, double sum);

  void merge(const Moments& right);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double mean() const;
  [[nodiscard]] double variance() const;  // estimate for the population sampled by the values
  [[nodiscard]] double sd() const;
  [[nodiscard]] double skewness() const;
  [[nodiscard]] double kurtosis() const;  // beyond that of the normal distribution
  /// The standard error of the mean.
  [[nodiscard]] double error() const;

  void store(Writer& writer) const;
  void load(Reader& reader);
  bool operator==(const Moments&) const = default;

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0.0;
  double square_ = 0.0, cube_ = 0.0, fourth_ = 0.0;  // sums of powers of deviations from the mean
};

}  // namespace loadpath::sweep
