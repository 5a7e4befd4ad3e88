// The best machine of a project, or the value at which a result has what was asked for, as a document.
#pragma once

#include "lib/project/sweep/best.hpp"
#include "lib/report/document.hpp"

namespace loadpath::report {

/// What was chosen, how good it is, and for every machine beside it what it fails or loses.
std::vector<Block> best_blocks(const project::Best& best);

std::vector<Block> seek_blocks(const project::SoughtValue& sought);

}  // namespace loadpath::report
