// The confidence of a sample: exact bounds of a share and of a quantile, for any distribution.
#pragma once

#include <cstdint>

namespace loadpath::sweep {

struct Interval {
  double low, high;
};

/// Bounds of the probability behind `met` of n, n > 0: Clopper and Pearson 1934, at least the required confidence.
Interval share_bounds(std::uint64_t met, std::uint64_t n, double confidence);

/// Ranks 1 ... n of the values that enclose the quantile; 0 and n + 1 if the sample is too small.
struct RankBounds {
  std::uint64_t low, high;
};
RankBounds rank_bounds(std::uint64_t n, double p, double confidence);

}  // namespace loadpath::sweep
