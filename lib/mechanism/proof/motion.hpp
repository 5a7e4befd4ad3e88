// The proof of the motion, from which the forces of inertia come: the joints are closed, and velocities and
// accelerations are those that joints and drives allow.
#pragma once

#include "lib/mechanism/proof/instant.hpp"

#include <span>

namespace loadpath::mechanism {

/// The largest gap of a joint or miss of a drive, in units of the mechanism's length or rad; or the largest error of
/// a constraint's velocity or acceleration over the largest of the links, centripetal accelerations among them.
double motion_residual(const Instant& instant, std::span<const Drive> drives);

}  // namespace loadpath::mechanism
