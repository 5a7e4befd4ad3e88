// Rules that a search has to keep: what they are about is not there before it.
#pragma once

#include "lib/project/run/evaluation/prepared_step.hpp"

#include <cstddef>

namespace loadpath::project {

/// Whether a rule is about the input that is searched for, or about those that the row gives which is. Of a load it may
/// be any: what a part needs is asked where it is loaded.
bool concerns_search(const PreparedStep& step, std::size_t rule);
/// Whether a rule is about what is not there before the search.
bool waits_for_search(const PreparedStep& step, std::size_t rule);

}  // namespace loadpath::project
