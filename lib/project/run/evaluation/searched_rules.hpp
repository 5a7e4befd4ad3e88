// Rules that a search must satisfy: their subjects exist only after it.
#pragma once

#include "lib/project/run/evaluation/prepared_step.hpp"

#include <cstddef>

namespace loadpath::project {

/// Whether a rule concerns the searched input, or the inputs that the searched row gives. For loads it may be any
/// rule, because requirements of a part are stated where it is loaded.
bool concerns_search(const PreparedStep& step, std::size_t rule);
/// Whether the candidates of a search must satisfy a rule: those that concern it, and of those that only warn the sizes
/// of a standard, where a row gives the bounds of the searched input.
bool must_hold_in_search(const PreparedStep& step, std::size_t rule);
/// Whether a rule needs values that exist only after the search.
bool waits_for_search(const PreparedStep& step, std::size_t rule);

}  // namespace loadpath::project
