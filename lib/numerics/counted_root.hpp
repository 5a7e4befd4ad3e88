// Roots of which it is known how many lie below any value, so that none is missed: natural frequencies.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace loadpath::numerics {

/// Number of roots below a value, and there a pole-free function that vanishes at each root.
struct Counted {
  std::size_t below = 0;
  double rest = 0.0;
};

/// Positive root number i, from 0, to a relative precision `finest`; NaN if there is none. Bracketed by the count,
/// from `first` by doubling and halving; refined by the Illinois variant of false position if the bracket has a
/// single root, else by bisection.
template <class Count>
double counted_root(std::size_t i, const Count& count, double first, double finest = 1e-13) {
  constexpr double highest = 1e12, least_of_all = 1e-200, none = std::numeric_limits<double>::quiet_NaN();
  double low = 0.0, high = first;
  Counted left, right = count(high);
  while (right.below <= i) {
    low = high, left = right;
    if ((high *= 2.0) > highest) return none;
    right = count(high);
  }
  while (low == 0.0 || left.below > i) {
    if (low > 0.0) high = low, right = left;
    if ((low = high / 2.0) < least_of_all) return none;
    left = count(low);
  }
  int kept = 0;  // end kept last: -1 low, 1 high
  while (high - low > finest * high) {
    const bool alone =
        right.below == left.below + 1 && (left.rest < 0.0) != (right.rest < 0.0) && std::isfinite(right.rest);
    const double guess = alone ? low + (high - low) * left.rest / (left.rest - right.rest) : 0.5 * (low + high);
    const double least = 0.3 * finest * high, next = std::clamp(guess, low + least, high - least);
    const Counted here = count(next);
    if (here.below > i) {
      high = next, right = here;
      if (std::exchange(kept, -1) == -1) left.rest *= 0.5;
    } else {
      low = next, left = here;
      if (std::exchange(kept, 1) == 1) right.rest *= 0.5;
    }
  }
  return 0.5 * (low + high);
}

}  // namespace loadpath::numerics
