// Values of [values] that a step takes under their own name, but for a share of them: a life over ten, half of K_A.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Lives, factors and pressures below, and strengths above the value of [values] that an expression computes them from;
/// loads and speeds that are a part of values by a bare number. They need a reason.
std::vector<ReducedLoad> values_in_part(const Step& step, const Project& project);

}  // namespace loadpath::project
