// The search for an input: a size to the smallest of its stock with which every check passes at every position, a row
// to the first of its table, a load to the largest.
#pragma once

#include "lib/project/run/evaluation/evaluation.hpp"

#include <vector>

namespace loadpath::project {

/// Sets what the step searches for; nothing where it searches for nothing. An issue where no check is asked for, so
/// that any would pass. `in_words`: why what is found is no smaller, where it comes from.
bool run_search(Evaluation& evaluation, bool in_words, std::vector<Issue>& issues);

}  // namespace loadpath::project
