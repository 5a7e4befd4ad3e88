// What is said of a search beside what it finds: that nothing limits it, which customs the result breaks.
#pragma once

#include "lib/project/run/evaluation/evaluation.hpp"

#include <vector>

namespace loadpath::project {

/// A search without a check; its hint names what asks for one.
Issue aimless_search(const PreparedStep& step, const Search& wanted);
/// Customs that what was found breaks, in the words in which a typed value would be warned of.
void warn_of_found(Evaluation& evaluation, const Search& wanted, std::vector<Issue>& issues);

}  // namespace loadpath::project
