// The phases of wheels against each other where the poses of a mechanism are approximate.
#pragma once

#include "lib/mechanism/model/model.hpp"

namespace loadpath::mechanism {

/// Closes the mechanism near the stated poses without the phases of its wheels, by steps of least norm in which a link
/// with a wheel turns only where nothing else can move, so that a wheel that only rolls keeps the angle that is stated;
/// then takes the phases there. Where the mechanism does not close so the phases are those of the stated poses.
void settle_phases(Model& model);

}  // namespace loadpath::mechanism
