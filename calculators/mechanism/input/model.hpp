// From the words of a project to the solver's model: names become indices, points become vectors.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/mechanism/model/model.hpp"

namespace loadpath::planar {

/// The model; the names in `in` have been checked. Links without a stated pose are placed as drawn, or by their joints.
mechanism::Model model_of(const Mechanism::Input& in);

}  // namespace loadpath::planar
