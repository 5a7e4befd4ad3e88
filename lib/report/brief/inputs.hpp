// The inputs of page 2.
#pragma once

#include "lib/report/brief/governing.hpp"
#include "lib/report/document.hpp"

#include <vector>

namespace loadpath::report {

/// The given inputs with their sources, as many as a height of half a page's width holds, mm: first those that the
/// governing modes follow from, then inputs of a step itself, then those of its lists.
Table inputs_table(const project::Project& project, const std::vector<Governing>& governing, double height);

}  // namespace loadpath::report
