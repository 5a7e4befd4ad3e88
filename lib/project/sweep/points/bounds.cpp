#include "lib/project/sweep/points/bounds.hpp"

#include "lib/account/fold.hpp"
#include "lib/simd/attributes.hpp"

#include <array>
#include <cstddef>
#include <limits>

namespace loadpath::project {

namespace {

LOADPATH_COLUMNS double count_outside(double low, double high, const double* si, std::size_t n) {
  double count = 0.0;
  std::array<double, 8> lane{};
  std::size_t i = 0;
  for (; i + lane.size() <= n; i += lane.size()) {
    for (std::size_t k = 0; k < lane.size(); ++k) lane[k] += si[i + k] >= low && si[i + k] <= high ? 0.0 : 1.0;
  }
  for (; i < n; ++i) count += si[i] >= low && si[i] <= high ? 0.0 : 1.0;
  for (const double more : lane) count += more;
  return count;
}

}  // namespace

bool all_within(const Range& bounds, std::span<const double> si) {
  const Range within = account::closed(bounds);
  return count_outside(within.low, within.high, si.data(), si.size()) == 0.0;
}

bool all_act(std::span<const double> si) {
  const double least = std::numeric_limits<double>::denorm_min(), infinity = std::numeric_limits<double>::infinity();
  return count_outside(least, infinity, si.data(), si.size()) == 0.0 ||
         count_outside(-infinity, -least, si.data(), si.size()) == 0.0;
}

}  // namespace loadpath::project
