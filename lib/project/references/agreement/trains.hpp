// A train next to the steps of its stages: gears of one size of which only the less loaded ones are rated, friction
// wheels with another ratio or less power than their stage, worm gears of another efficiency.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// For the step of a train, and for that of friction wheels.
std::vector<ReducedLoad> stages_of_trains(const Step& step, const Project& project);

}  // namespace loadpath::project
