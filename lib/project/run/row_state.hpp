// How a check or a limit came out that has a value.
#pragma once

#include "lib/account/state.hpp"
#include "lib/calculator/field.hpp"

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

}  // namespace loadpath::project
