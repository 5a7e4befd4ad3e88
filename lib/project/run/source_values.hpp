// Quantities of the steps that values are taken from, next to those of the step: teeth of a stage of the train whose
// torque it takes, pitch diameters of the gears of a mechanism.
#pragma once

#include "lib/project/run/neighbours.hpp"

#include <string>
#include <vector>

namespace loadpath::project {

/// Inputs: a key is on the shaft whose torque it takes, a gear pair is a stage of its train.
void add_source_values(const Evaluation& evaluation, const Known& known, std::vector<Neighbour>& all);

/// A result, or a value of a row, that differs from that of the step which a load is taken from.
struct Differing {
  std::string load;  // the load that is taken
  Message text;
};
std::vector<Differing> differing_results(const Evaluation& evaluation, const Results& results, const Known& known);

}  // namespace loadpath::project
