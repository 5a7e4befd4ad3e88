// The phases of wheels against each other where the poses of a mechanism are approximate.
#pragma once

#include "lib/mechanism/model/model.hpp"

namespace loadpath::mechanism {

/// Closes the mechanism near the stated poses without the phases of its wheels, by steps of minimum norm in which a
/// link with a wheel rotates only if nothing else can move, so that a wheel that only rolls keeps the stated angle;
/// then takes the phases there. If the mechanism does not close like this, the phases are those of the stated poses.
void settle_phases(Model& model);

}  // namespace loadpath::mechanism
