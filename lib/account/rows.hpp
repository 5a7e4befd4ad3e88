// The state of a check or a limit at a value.
#pragma once

#include "lib/account/state.hpp"
#include "lib/calculator/record.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace loadpath::account {

/// Tolerance of a utilisation: a minimum size that just suffices must pass, and a rounded zero may have either sign.
constexpr double rounding_of_utilisation = 1e-9;

constexpr bool is_passed(double utilisation) {
  return utilisation >= -rounding_of_utilisation && utilisation <= 1.0 + rounding_of_utilisation;
}

/// Utilisations are not negative: such a check is beyond its method.
constexpr State state_of_check(double utilisation) {
  if (utilisation < -rounding_of_utilisation) return State::not_covered;
  return pass_if(is_passed(utilisation));
}

constexpr State state_of_limit(const Range& bounds, bool is_criterion, double si) {
  if (bounds.holds(si)) return State::pass;
  return is_criterion ? State::fail : State::not_covered;
}

/// The state of the field of a check or a limit; empty if the calculator leaves the field unset because it does not
/// apply.
inline std::optional<State> state_of_row(const FieldInfo& row, double si) {
  if (std::isnan(si)) return row.where_set ? std::nullopt : std::optional(State::not_available);
  return row.role == Role::check ? state_of_check(si) : state_of_limit(row.bounds, row.is_criterion, si);
}
/// The smallest size that a search may take where the calculated one is `least`.
constexpr double least_candidate(double least) { return least * (1.0 - rounding_of_utilisation); }

/// Whether a search may take a candidate with that row.
inline bool is_kept(const FieldInfo& row, double si) {
  return state_of_row(row, si).value_or(State::pass) == State::pass;
}

/// Whether a load is given and not zero.
inline bool acts(double si) { return !std::isnan(si) && si != 0.0; }

/// The value of a limit farthest beyond the nearer bound, or nearest to it; bounds of non-negative quantities are
/// never near zero, and NaN is farther than any number.
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

}  // namespace loadpath::account
