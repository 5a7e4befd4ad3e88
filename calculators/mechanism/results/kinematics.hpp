// What a planar mechanism gives of its motion beside places, velocities and accelerations: motion along guides,
// derivatives of position functions, transmission angles, strokes.
#pragma once

#include "calculators/mechanism/results/output.hpp"
#include "lib/mechanism/model/model.hpp"

#include <vector>

namespace loadpath::planar {

void add_kinematic_outputs(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out);
std::vector<ResultPattern> kinematic_result_patterns();

}  // namespace loadpath::planar
