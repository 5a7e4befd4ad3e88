// The search for an input: a size to the smallest of its stock with which every check passes at every position, a row
// to the first of its table, a load to the largest.
#pragma once

#include "lib/project/run/search/candidates.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::project {

/// Sets the searched inputs of the step, if any. An issue if no check is active, because any candidate would pass.
/// `in_words`: the origin of the result explains why it is not smaller.
bool run_search(Evaluation& evaluation, bool in_words, std::vector<Issue>& issues, const JointRow* together = nullptr);

/// Of a step that searches for one row: for each row the first one of its kind that passes, the number of rows if none
/// does. `alike`: for each row the first one of its kind.
std::vector<std::size_t> first_rows_that_pass(Evaluation& evaluation, std::span<const std::size_t> alike);

}  // namespace loadpath::project
