// How high panels are in print: an estimate from their letters, by which pages are filled.
#pragma once

#include "lib/report/document.hpp"

namespace loadpath::report {

constexpr double page_width = 171.0;   // mm, without the gap between columns
constexpr double page_height = 252.0;  // mm

/// The height of paragraphs and tables under a heading, in a column of a width, mm.
double height_of(const Panel& panel, double width);
/// The height of a panel of one table, whose rows are single lines, mm.
double height_of_table(const Panel& panel);
/// The height of the highest stack of a band, mm.
double height_of(const Band& band);

}  // namespace loadpath::report
