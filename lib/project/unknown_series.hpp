// Names of series that a solved project does not have.
#pragma once

#include "lib/project/project.hpp"
#include "lib/project/series_choice.hpp"
#include "lib/text/issue.hpp"

#include <vector>

namespace loadpath::project {

/// The patterns that choose no series of a solved project, with similar names.
std::vector<FieldFault> unknown_series(const SeriesChoice& choice, const Project& project);

}  // namespace loadpath::project
