// Load components that a step leaves out of the loads it takes one by one.
#pragma once

#include "lib/project/run/evaluation/inputs.hpp"

#include <string>

namespace loadpath::project {

/// Whether a component is more than its rounding at any position.
bool acts(const Value& component);

/// Paths of the components that act and that no input of the step holds: a spur gear has no axial force, and F_x and
/// F_y that are calculated from the torque of a gear may be all of its force.
std::string left_loads(const PreparedStep& step, const Inputs& inputs, const Known& known);

}  // namespace loadpath::project
