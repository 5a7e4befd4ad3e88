// Every point of a finite set of designs.
#pragma once

#include "lib/sweep/search/trials.hpp"

namespace loadpath::sweep {

/// The best of all points, the first of equal ones; every variable is discrete, the last one changes first.
[[nodiscard]] Trial best_of_all(Trials& trials);

/// The places of the discrete variables at combination `index`; continuous ones stay.
void set_combination(const std::vector<Variable>& variables, std::uint64_t index, Places& at);

}  // namespace loadpath::sweep
