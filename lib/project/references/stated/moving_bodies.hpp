// Masses, friction and springs of a mechanism that only [values] state.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// "m_rod = 3 kg" next to a link "rod" without mass; "mu" next to joints without friction.
std::vector<ReducedLoad> bodies_stated_only(const Step& step, const Project& project);

}  // namespace loadpath::project
