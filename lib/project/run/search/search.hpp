// The search for an input: a size to the smallest of its stock with which every check passes at every position, a row
// to the first of its table, a load to the largest.
#pragma once

#include "lib/project/run/evaluation/evaluation.hpp"

#include <vector>

namespace loadpath::project {

/// Sets what the step searches for; nothing where it searches for nothing. An issue where no check is asked for, so
/// that any would pass. `in_words`: why what is found is no smaller, where it comes from.
bool run_search(Evaluation& evaluation, bool in_words, std::vector<Issue>& issues);

/// A search without a check; its hint names what asks for one.
Issue aimless_search(const PreparedStep& step, const Search& wanted);
/// Customs that what was found breaks, in the words in which a typed value would be warned of.
void warn_of_found(Evaluation& evaluation, const Search& wanted, std::vector<Issue>& issues);

}  // namespace loadpath::project
