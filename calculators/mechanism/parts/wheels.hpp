// Forces of wheels: teeth, rolling contacts, the spans of belts.
#pragma once

#include "calculators/mechanism/results/output.hpp"
#include "lib/mechanism/model/model.hpp"

#include <cstddef>
#include <vector>

namespace loadpath::planar {

/// Outputs of the joint with this index; none if it has no wheels.
void add_wheel_outputs(const mechanism::Joint& joint, std::size_t index, std::vector<Output>& out);
void list_wheel_patterns(std::vector<ResultPattern>& patterns);

}  // namespace loadpath::planar
