// Faults of tolerances and of the outputs whose errors are wanted.
#pragma once

#include "calculators/mechanism/input/names.hpp"
#include "lib/mechanism/model/model.hpp"

#include <vector>

namespace loadpath::planar {

/// Tolerances and outputs that do not say what they are of, or of what is not there. Needs no values.
void check_accuracy(NameFaults& faults);

/// Tolerances as wide as what they are of: lengths, radii, masses. Needs values, and names that are right.
void check_half_widths(const Mechanism::Input& in, const mechanism::Model& model, std::vector<FieldFault>& faults);

}  // namespace loadpath::planar
