// A power, torque or pull of [values] that no step takes, next to a drive whose load is stated as another quantity.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// "P = 12 kW" next to T_1 and n_1 of 5 kW, "T_2 = 200 N*m" next to P and n_1. They need a reason; loads under their
/// own names are compared in machine/left_out.hpp.
std::vector<ReducedLoad> loads_stated_otherwise(const Step& step, const Project& project);

/// "P = =values.P/values.K_A" in a step that applies this factor again: it has no effect then.
std::vector<ReducedLoad> factors_cancelled(const Step& step, const Project& project);

}  // namespace loadpath::project
