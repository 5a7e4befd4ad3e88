// What fits on a page: bands of formulas, references, and what moves to a half-empty page before.
#pragma once

#include "lib/report/document.hpp"

#include <vector>

namespace loadpath::report {

/// The height of a band of one derivation or of the references, mm.
double height_of_lines(const Band& band);

/// The citations that fit into a height.
Table fitting(Table sources, double height);

/// Fills the free height of page 1, mm, with what follows it, and the next pages after it.
void refill(double free, std::vector<Page>& pages);

}  // namespace loadpath::report
