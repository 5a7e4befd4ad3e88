// From checks and limits to the state of a mode, for many points: numbers in, numbers out.
#pragma once

#include "lib/account/state.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace loadpath::project {

/// What the rows of a mode come to, point by point.
struct Fold {
  std::vector<signed char> worst;  // a State; -1: there is no row
  std::vector<char> checked;
  std::vector<double> utilisation;  // of what governs; NaN of a limit

  void clear(std::size_t n) {
    worst.assign(n, -1);
    checked.assign(n, 0);
    utilisation.assign(n, std::numeric_limits<double>::quiet_NaN());
  }
  /// A row: of the worst ones the most utilised governs.
  void take(std::size_t i, account::State state, double used) {
    const bool worse = worst[i] < 0 || account::rank(state) > account::rank(static_cast<account::State>(worst[i]));
    const bool as_bad = static_cast<account::State>(worst[i]) == state && used == used && !(utilisation[i] >= used);
    if (!worse && !as_bad) return;
    worst[i] = static_cast<signed char>(state);
    utilisation[i] = used;
  }
};

}  // namespace loadpath::project
