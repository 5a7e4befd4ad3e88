#include "lib/mechanism/columns/largest.hpp"

#include "lib/mechanism/columns/chain_lanes.hpp"
#include "lib/simd/attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::mechanism {

LOADPATH_COLUMNS double largest_size(std::span<const double> x) {
  std::array<double, lane_count> most{};
  std::size_t i = 0;
  for (; i + lane_count <= x.size(); i += lane_count) {
    const double* const of = x.data() + i;
    LOADPATH_LANEWISE
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const double size = std::abs(of[lane]);
      most[lane] = size > most[lane] ? size : most[lane];
    }
  }
  for (; i < x.size(); ++i) most[0] = std::abs(x[i]) > most[0] ? std::abs(x[i]) : most[0];
  return *std::max_element(most.begin(), most.end());
}

LOADPATH_COLUMNS double largest_square(std::span<const double> x, std::span<const double> y) {
  std::array<double, lane_count> most{};
  std::size_t i = 0;
  for (; i + lane_count <= x.size(); i += lane_count) {
    const double *const along = x.data() + i, *const across = y.data() + i;
    LOADPATH_LANEWISE
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const double square = along[lane] * along[lane] + across[lane] * across[lane];
      most[lane] = square > most[lane] ? square : most[lane];
    }
  }
  for (; i < x.size(); ++i) {
    const double square = x[i] * x[i] + y[i] * y[i];
    most[0] = square > most[0] ? square : most[0];
  }
  return *std::max_element(most.begin(), most.end());
}

LOADPATH_COLUMNS bool raise_to_squares(std::span<const double> x, std::span<const double> y, std::span<double> most) {
  std::array<double, lane_count> sum{};  // NaN and infinities do not vanish with zero
  std::size_t i = 0;
  for (; i + lane_count <= most.size(); i += lane_count) {
    const double *const along = x.data() + i, *const across = y.data() + i;
    double* const to = most.data() + i;
    LOADPATH_LANEWISE
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const double square = along[lane] * along[lane] + across[lane] * across[lane];
      to[lane] = square > to[lane] ? square : to[lane];
      sum[lane] += square * 0.0;
    }
  }
  for (; i < most.size(); ++i) {
    const double square = x[i] * x[i] + y[i] * y[i];
    most[i] = square > most[i] ? square : most[i];
    sum[0] += square * 0.0;
  }
  return std::ranges::all_of(sum, [](double lane) { return lane == 0.0; });
}

LOADPATH_COLUMNS void take_roots(std::span<double> squares) {
  double* const x = squares.data();
  LOADPATH_POINTWISE
  for (std::size_t i = 0; i < squares.size(); ++i) x[i] = std::sqrt(x[i]);
}

}  // namespace loadpath::mechanism
