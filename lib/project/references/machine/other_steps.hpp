// A step next to the other steps of the same machine: factors that those which take its loads apply, motors, flywheels.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Application and partial factors that are higher in a step which takes a load of this one.
std::vector<ReducedLoad> factors_of_takers(const Step& step, const Project& project);

/// Inputs of a run of a drive that need a reason: a speed that no shaft has, a motor that is too strong for the shaft,
/// parts without a flywheel at this speed.
std::vector<ReducedLoad> values_of_runs(const Step& step, const Project& project);

}  // namespace loadpath::project
