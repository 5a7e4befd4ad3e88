// The search for an input: a size to the smallest of its stock with which every check passes at every position, a row
// to the first of its table, a load to the largest.
#pragma once

#include "lib/project/run/evaluation/evaluation.hpp"

#include <vector>

namespace loadpath::project {

/// Sets the searched inputs of the step, if any. An issue if no check is active, because any candidate would pass.
/// `in_words`: the origin of the result explains why it is not smaller.
bool run_search(Evaluation& evaluation, bool in_words, std::vector<Issue>& issues);

}  // namespace loadpath::project
