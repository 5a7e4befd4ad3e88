// Quantities of the steps that values are taken from, next to those of the step: teeth of a stage of the train whose
// torque it takes, pitch diameters of the gears of a mechanism.
#pragma once

#include "lib/project/run/neighbours.hpp"
#include "lib/project/run/typed_values.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs: a key is on the shaft whose torque it takes, a gear pair is a stage of its train.
void add_sources_beside(const Evaluation& evaluation, const Known& known, std::vector<Neighbour>& all);

/// Results, and values of rows, that differ from those sources, without a reason for the load that is taken there.
void compare_results(const Evaluation& evaluation, const Results& results, const Known& known, WeighedValues& weighed);

}  // namespace loadpath::project
