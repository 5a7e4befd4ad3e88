// Cylinders between two points: what is wrong with them, and the links and joints that they become.
#pragma once

#include "calculators/mechanism/input/names.hpp"

namespace loadpath::planar {

/// Cylinders that name no joint and no links, or too much. Needs no values.
void check_cylinders(NameFaults& faults);

/// The mechanism with each cylinder C between two points as a barrel that turns about its first end, C_barrel, a rod
/// that turns about its second, C_rod, and the slide C_bore between them, which is driven, or pushed by the given
/// force. They have no mass. The place along C_bore is the length of the cylinder.
Mechanism::Input with_cylinders(const Mechanism::Input& given);

}  // namespace loadpath::planar
