// Loads that are a part of what the usual formula gives with values of [values]: a torque of P/n/1.5, a force of half
// of the pressure on a bore, a stress of four times the area.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// They need a reason.
std::vector<ReducedLoad> parts_of_formulas(const Step& step, const Project& project);

}  // namespace loadpath::project
