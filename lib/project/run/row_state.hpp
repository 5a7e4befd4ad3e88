// How a check or a limit came out that has a value.
#pragma once

#include "lib/account/state.hpp"
#include "lib/calculator/field.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace loadpath::project {

/// Of a utilisation: a size that is just the least one passes, and what is just zero may have a sign.
constexpr double rounding_of_utilisation = 1e-9;

constexpr bool is_passed(double utilisation) {
  return utilisation >= -rounding_of_utilisation && utilisation <= 1.0 + rounding_of_utilisation;
}

/// No utilisation is negative: such a check is beyond its method.
constexpr account::State state_of_check(double utilisation) {
  if (utilisation < -rounding_of_utilisation) return account::State::not_covered;
  return account::pass_if(is_passed(utilisation));
}

constexpr account::State state_of_limit(const Range& bounds, bool is_criterion, double si) {
  if (bounds.holds(si)) return account::State::pass;
  return is_criterion ? account::State::fail : account::State::not_covered;
}

/// Whether a load is there and not zero.
inline bool acts(double si) { return !std::isnan(si) && si != 0.0; }

/// Of the values of a limit the one that is farthest beyond the nearer bound, or nearest to it; what cannot be negative
/// is never near zero, and what is no number is beyond all.
inline double farthest_from(const Range& bounds, std::span<const double> si) {
  const auto distance = [&](double x) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (std::isnan(x)) return infinity;
    const bool from_zero = bounds.low == 0.0 && x >= 0.0 && !std::isinf(bounds.high);
    return std::max(from_zero ? -infinity : bounds.low - x, x - bounds.high);
  };
  return *std::max_element(si.begin(), si.end(),
                           [&](double a, double b) { return numerics::exceeds(distance(b), distance(a)); });
}

}  // namespace loadpath::project
