// Forces of wheels: teeth, rolling contacts, the spans of belts.
#pragma once

#include "calculators/mechanism/planar_outputs.hpp"

#include <cstddef>
#include <vector>

namespace loadpath {

/// Of the joint with this index; nothing where it has no wheels.
void add_wheel_outputs(const mechanism::Joint& joint, std::size_t index, std::vector<MechanismOutput>& out);
void list_wheel_patterns(std::vector<ResultPattern>& patterns);

}  // namespace loadpath
