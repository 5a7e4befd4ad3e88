// All results of a planar mechanism.
#pragma once

#include "calculators/mechanism/results/output.hpp"
#include "lib/mechanism/model/model.hpp"

#include <vector>

namespace loadpath::planar {

/// All outputs, in the order of reports. `model` must outlive nothing: what the readers need is copied.
std::vector<Output> mechanism_outputs(const Mechanism::Input& in, const mechanism::Model& model);

/// The same before there is a model: NAME stands for the names in it.
std::vector<ResultPattern> mechanism_result_patterns();

}  // namespace loadpath::planar
