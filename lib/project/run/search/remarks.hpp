// Remarks on a search in addition to its result: that nothing limits it, or the customs that the result violates.
#pragma once

#include "lib/project/run/evaluation/evaluation.hpp"

#include <vector>

namespace loadpath::project {

/// The issue of a search without a check; its hint names inputs that activate one.
Issue aimless_search(const PreparedStep& step, const Search& wanted);
/// Customs that the sizes found violate, worded as for typed values.
void warn_of_customs(Evaluation& evaluation, std::vector<Issue>& issues);
/// The same of an unusual size.
void warn_of_found(Evaluation& evaluation, const Search& wanted, std::vector<Issue>& issues);

}  // namespace loadpath::project
