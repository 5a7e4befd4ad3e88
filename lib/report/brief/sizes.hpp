// The chosen sizes with their materials, and why the next smaller ones do not do.
#pragma once

#include "lib/report/document.hpp"
#include "lib/report/summary/summary.hpp"

#include <vector>

namespace loadpath::report {

/// Sized values first, then the given sizes: a row for each component, in so many lines at most.
Table sizes_table(const project::Project& project, const Summary& summary, std::size_t most);
/// Whether a component has a size, and not only results such as a time or a torque.
bool has_sizes(const project::Project& project);
/// The lines of that table as it is set.
std::size_t lines_of(const Table& sizes);
/// The fewest lines in which every component has its row.
std::size_t fewest_lines(const project::Project& project, const Summary& summary);
/// Whether page 1 has room for the titles of steps in place of their names.
bool titles_fit(const project::Project& project, const Summary& summary);
/// The next smaller size of each value that was found, and the mode that it fails.
std::vector<Block> next_size_notes(const Summary& summary, std::size_t most);

}  // namespace loadpath::report
