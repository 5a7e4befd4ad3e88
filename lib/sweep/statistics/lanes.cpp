#include "lib/sweep/statistics/lanes.hpp"

#include "lib/simd/attributes.hpp"

#include <algorithm>

namespace loadpath::sweep {

LOADPATH_COLUMNS bool all_finite(std::span<const double> column) {
  const double* const x = column.data();
  Lanes missing{};
  in_lanes(column.size(), [&](std::size_t i, std::size_t lane) { missing[lane] += is_finite(x[i]) ? 0.0 : 1.0; });
  return sum_of(missing) == 0.0;
}

LOADPATH_COLUMNS double count_of(double value, std::span<const double> column) {
  const double* const x = column.data();
  Lanes count{};
  in_lanes(column.size(), [&](std::size_t i, std::size_t lane) { count[lane] += x[i] == value ? 1.0 : 0.0; });
  return sum_of(count);
}

LOADPATH_COLUMNS double largest_of(std::span<const double> column) {
  const double* const x = column.data();
  Lanes largest;
  largest.fill(-std::numeric_limits<double>::infinity());
  in_lanes(column.size(),
           [&](std::size_t i, std::size_t lane) { largest[lane] = x[i] > largest[lane] ? x[i] : largest[lane]; });
  return *std::max_element(largest.begin(), largest.end());
}

}  // namespace loadpath::sweep
