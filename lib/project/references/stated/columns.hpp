// Columns next to [values] that no step takes.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs of a column that need a reason: an eccentricity or a bending moment is stated, or a stroke that is longer.
std::vector<ReducedLoad> columns_stated_otherwise(const Step& step, const Project& project);

/// An eccentricity of [values] whose moment a link is not given.
std::vector<ReducedLoad> eccentric_links(const Step& step, const Project& project);

/// A bar in tension for which buckling is required: the sign of a stated force.
std::vector<ReducedLoad> bars_in_tension(const Step& step, const Project& project);

}  // namespace loadpath::project
