// The numbers of a motion in view units, as compact JSON.
#pragma once

#include "lib/draw/plan/picture.hpp"
#include "lib/draw/scheme/fit.hpp"

#include <string>
#include <vector>

namespace loadpath::draw {

/// Columns over the frames are whole numbers, each less the one before; a column that never changes is one number.
/// `plans`: where the force plan of each link lies.
std::string motion_data(const Motion& motion, const Fit& scheme, const std::vector<PlanFit>& plans);

}  // namespace loadpath::draw
