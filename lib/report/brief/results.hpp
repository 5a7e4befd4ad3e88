// The results of page 2: sections of the main part, bearings, joints.
#pragma once

#include "lib/report/brief/governing.hpp"
#include "lib/report/document.hpp"

#include <vector>

namespace loadpath::report {

/// The lists of a step in which its modes govern, with the columns from which the checks follow. Lists of the same
/// elements are one table if it fits into a line; else they follow each other, or are one table without some columns.
struct ListPanels {
  std::vector<Panel> apart, in_a_line;
};
ListPanels list_panels(const project::Step& step, const account::Modes& modes);

/// The rows of a table that have the highest utilisations, in their order, and how many others the appendix has.
Table most_utilised_rows(const Table& table, std::size_t most);

/// The forces on a shaft, of its mounted components and its bearings; empty for other steps.
std::vector<Panel> load_panels(const project::Step& step);

/// The leading results of the other steps; steps of one calculator share a table. At most so many rows in all.
std::vector<Panel> result_panels(const project::Project& project, const Summary& summary, const project::Step* main,
                                 std::size_t most);

}  // namespace loadpath::report
