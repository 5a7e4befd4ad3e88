// What fits on a page: bands of formulas, references, and what moves to a half-empty page before.
#pragma once

#include "lib/report/document.hpp"

#include <vector>

namespace loadpath::report {

/// The height of a band of one derivation or of the references, mm.
double height_of_lines(const Band& band);

/// The citations that fit into a height.
Table fitting(Table sources, double height);

/// Moves the first bands of page 2 into the free height of page 1, mm, unless this would leave more pages half empty.
void fill_first(double free, std::vector<Page>& pages);

}  // namespace loadpath::report
