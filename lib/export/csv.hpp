// The series of a solved project as comma-separated columns, one file per axis; the unit is in the column's name.
#pragma once

#include "lib/project/project.hpp"
#include "lib/project/series_choice.hpp"

#include <string>
#include <utility>
#include <vector>

namespace loadpath::exports {

/// File names ("lever.csv") and texts, a file for each step that has chosen series.
std::vector<std::pair<std::string, std::string>> csv_of(const project::Project& project,
                                                        const project::SeriesChoice& choice = {});

}  // namespace loadpath::exports
