// Requirements and limits of [values] with the name of a part, which no step takes.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs that need a reason: an allowable stress above "p_adm_bush", a required safety factor below "n_st_min", a
/// range "U_min" to "U_max" without "U".
std::vector<ReducedLoad> requirements_stated_otherwise(const Step& step, const Project& project);

}  // namespace loadpath::project
