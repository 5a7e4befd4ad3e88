// The search for the rows of two steps together, each of which takes values of the row of the other one
// (lib/project/references/row_pairs.hpp).
#pragma once

#include "lib/project/references/row_pairs.hpp"

namespace loadpath::project {

/// Finds the pair of rows with which both steps pass and whose sizes, masses of bearings, are the smallest sum. Each
/// step then keeps to its row, and the other one takes the values of that row before it is solved. If no pair passes,
/// neither step has a row.
void find_rows_together(Project& project, const RowPair& pair, const Known& known);

}  // namespace loadpath::project
