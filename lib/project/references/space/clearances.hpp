// Gears, bearings and shafts that would occupy the same space: on one shaft, and on two that a gear pair connects.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Positions on a shaft that need a reason: a gear that touches the neighbouring shaft, its gears or its bearings, or a
/// bearing of its own shaft; pairs between two shafts that contradict each other; two gears without a direction.
std::vector<ReducedLoad> values_in_collision(const Step& step, const Project& project);

}  // namespace loadpath::project
