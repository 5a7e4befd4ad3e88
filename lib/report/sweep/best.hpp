// The best design of a project, or the value at which a result reaches its target, as a document.
#pragma once

#include "lib/project/sweep/studies/best.hpp"
#include "lib/report/document.hpp"

namespace loadpath::report {

/// The choices, their objective, and for every neighbouring design the check that it fails or the loss.
std::vector<Block> best_blocks(const project::Best& best);

std::vector<Block> seek_blocks(const project::SoughtValue& sought);

}  // namespace loadpath::report
