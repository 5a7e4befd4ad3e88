// Notches of a shaft at its mounted components: a keyway under one that is integral, the hole of a cross pin.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Seats and notches of a shaft that need a reason: a component integral with the shaft over the keyway of a connection
/// that no seat takes, and a cross hole smaller than the pin through it.
std::vector<ReducedLoad> notches_of_seats(const Step& step, const Project& project);

}  // namespace loadpath::project
