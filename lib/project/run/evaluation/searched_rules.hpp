// Rules that a search must satisfy: their subjects exist only after it.
#pragma once

#include "lib/project/run/evaluation/prepared_step.hpp"

#include <cstddef>

namespace loadpath::project {

/// Whether a rule concerns the searched input, or the inputs that the searched row gives. For loads it may be any
/// rule, because requirements of a part are stated where it is loaded.
bool concerns_search(const PreparedStep& step, std::size_t rule);
/// Whether a rule needs values that exist only after the search.
bool waits_for_search(const PreparedStep& step, std::size_t rule);

}  // namespace loadpath::project
