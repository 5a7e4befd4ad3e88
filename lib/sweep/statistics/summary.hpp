// The statistics of a result over all points of a sweep, without storing the points.
#pragma once

#include "lib/sweep/statistics/forest.hpp"
#include "lib/sweep/statistics/moments.hpp"
#include "lib/sweep/statistics/sketch.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace loadpath::sweep {

struct Extreme {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::uint64_t index = 0;  // index of its point; the first if there are several

  /// Keeps the larger one; NaN is passed over.
  void take(double other, std::uint64_t of) {
    const bool first = std::isnan(value) && !std::isnan(other);
    if (first || other > value || (other == value && of < index)) value = other, index = of;
  }
};

class Summary {
 public:
  /// The values of a block, the first of which belongs to point `first`. False, and nothing is done, if the block is
  /// there already; likewise merge().
  bool add(std::uint64_t block, std::uint64_t first, std::span<const double> values);
  bool merge(const Summary& other);

  [[nodiscard]] std::uint64_t count() const { return count_; }      // number of finite values
  [[nodiscard]] std::uint64_t missing() const { return missing_; }  // number of points without one
  [[nodiscard]] Moments moments() const { return moments_.total(); }
  [[nodiscard]] Extreme min() const { return min_; }  // NaN if there is no value
  [[nodiscard]] Extreme max() const { return max_; }
  [[nodiscard]] Ranks ranks() const { return Ranks(sketch_); }

  void store(Writer& writer) const;
  void load(Reader& reader);

 private:
  std::uint64_t count_ = 0, missing_ = 0;
  Extreme min_, max_;
  Forest<Moments> moments_;
  Sketch sketch_;
};

}  // namespace loadpath::sweep
