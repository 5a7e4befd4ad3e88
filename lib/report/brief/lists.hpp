// Where the lists of the main part, sections and their safety factors, are printed.
#pragma once

#include "lib/report/brief/governing.hpp"
#include "lib/report/document.hpp"

#include <vector>

namespace loadpath::report {

constexpr double of_sources = 40.0;  // mm of page 3, below the derivations

struct Lists {
  std::vector<Panel> checking;     // page 2
  std::vector<Panel> recomputing;  // page 3
};
/// The lists of a step and the loads on it, as far as page 2 has `room`, mm. Lists of the same elements are below each
/// other if there is room for all; else the further ones are on page 3, if its derivations lose no line by that; else
/// they are one table, without the columns that do not fit into a line.
Lists lists_of(const project::Project& project, const project::Step& step, const Summary& summary,
               const std::vector<Governing>& rows, double room);

}  // namespace loadpath::report
