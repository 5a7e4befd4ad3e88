// The numbers of a motion in view units, as compact JSON.
#pragma once

#include "lib/draw/plan/picture.hpp"
#include "lib/draw/scheme/fit.hpp"

#include <string>
#include <vector>

namespace loadpath::draw {

/// Columns over the frames are integers, each minus the one before; a constant column is one number. `plans`:
/// positions of the force plans of the links.
std::string motion_data(const figure::Motion& motion, const Fit& scheme, const std::vector<PlanFit>& plans);

}  // namespace loadpath::draw
