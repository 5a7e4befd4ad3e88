// The inputs that influence a result, as tables and figures.
#pragma once

#include "lib/project/sweep/studies/influence.hpp"
#include "lib/report/document.hpp"

namespace loadpath::report {

std::vector<Block> influence_blocks(const project::Influence& influence);

}  // namespace loadpath::report
