// The quantiles of few values exactly, of many in bounded memory (sketch.hpp); independent of the order.
#pragma once

#include "lib/sweep/statistics/sketch.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::sweep {

class Values {
 public:
  /// Infinite values and NaN are not counted.
  void add(std::span<const double> values);
  void merge(const Values& other);
  void clear();

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// With linear interpolation between ranks p (n - 1); NaN if there are no values.
  [[nodiscard]] double quantile(double p) const;

  void store(Writer& writer) const;
  void load(Reader& reader);

 private:
  static constexpr std::size_t most_exact = 4096;
  void take(double value);

  std::uint64_t count_ = 0;
  std::vector<double> exact_;  // while there are few
  Sketch sketch_;              // of all, once there are more
};

}  // namespace loadpath::sweep
