// Faults in the words of a mechanism, before a model is made of them and afterwards.
#pragma once

#include "calculators/mechanism/input/names.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/text/issue.hpp"

#include <vector>

namespace loadpath::planar {

/// Names that do not exist, points that are not on their link, doubtful alternatives. Needs no values.
void check_names(NameFaults& faults);

/// In a drawing one letter is one point: two links may share it only where a pin, or weld, of that name joins them. The
/// names are right.
void check_shared_points(NameFaults& faults);

/// Gravity is a magnitude. Needs values.
std::vector<FieldFault> check_gravity(const Mechanism::Input& in);
/// Whether links with a mass have no weight.
bool leaves_out_weights(const Mechanism::Input& in);

/// Pins that two drawn links show at different places. Needs values.
std::vector<FieldFault> check_drawing(const Mechanism::Input& in, const mechanism::Model& model);

}  // namespace loadpath::planar
