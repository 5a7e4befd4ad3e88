// The points of a sweep as lines of CSV: number, inputs, results, state. Numbers in the unit of their column, the
// shortest that read back; a missing value is an empty cell.
#pragma once

#include "lib/project/sweep/blocks.hpp"

#include <string>

namespace loadpath::exports {

std::string csv_head(const project::SweepPlan& plan);
/// Appends a line for each point of the block.
void append_csv(const project::SweepPlan& plan, const project::SolvedBlock& block, std::string& text);

}  // namespace loadpath::exports
