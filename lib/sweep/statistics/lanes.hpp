// Sums, counts and extremes of a column in eight lanes, added in one order at the end: as fast as the registers are
// wide, and the same bits with registers of any width.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace loadpath::sweep {

inline constexpr std::size_t lanes = 8;
using Lanes = std::array<double, lanes>;

inline bool is_finite(double x) { return std::abs(x) <= std::numeric_limits<double>::max(); }

inline double sum_of(const Lanes& lane) {
  return ((lane[0] + lane[4]) + (lane[2] + lane[6])) + ((lane[1] + lane[5]) + (lane[3] + lane[7]));
}

/// Calls each(i, lane) for 0 <= i < n.
template <class Each>
inline void in_lanes(std::size_t n, const Each& each) {
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) each(i + lane, lane);
  }
  for (std::size_t lane = 0; i < n; ++i, ++lane) each(i, lane);
}

[[nodiscard]] bool all_finite(std::span<const double> column);
/// The number of values equal to `value`.
[[nodiscard]] double count_of(double value, std::span<const double> column);
/// NaN is skipped; minus infinity if there is nothing else.
[[nodiscard]] double largest_of(std::span<const double> column);

}  // namespace loadpath::sweep
