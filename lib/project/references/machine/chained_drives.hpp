// Drives in a row: what runs at the speed of another one's output takes the power that this one passes on.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// The power or torque of a drive that is chained to another one only by its speed, where it differs from the power of
/// that one by more than losses.
std::vector<ReducedLoad> powers_of_chained(const Step& step, const Project& project);

}  // namespace loadpath::project
