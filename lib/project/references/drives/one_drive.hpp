// Torque, speed and hand of one drive that two steps state: they belong to the same shaft, and to the same gears.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// A torque of one shaft of a drive with the speed of another: "T_1 = =worm.T_2" with "n_1 = =worm.n_1".
std::vector<ReducedLoad> torques_at_other_speeds(const Step& step, const Project& project);

/// The hand of a gear whose mate on another shaft is taken from another step of the same pair: with the opposite hand
/// and the same data, or with the same hand where that step has the gears the other way round.
std::vector<ReducedLoad> hands_in_disagreement(const Step& step, const Project& project);

}  // namespace loadpath::project
