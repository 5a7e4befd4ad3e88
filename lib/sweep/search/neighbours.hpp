// The neighbours of a design in the stock.
#pragma once

#include "lib/sweep/search/problem.hpp"

namespace loadpath::sweep {

/// One discrete variable changed: by one and by up to `reach` places in both directions; words to every other word.
[[nodiscard]] std::vector<Places> neighbours_of(const std::vector<Variable>& variables, const Places& at, int reach);

/// Two discrete variables changed at once, each by one place or to every other word.
[[nodiscard]] std::vector<Places> across(const std::vector<Variable>& variables, const Places& at);

}  // namespace loadpath::sweep
