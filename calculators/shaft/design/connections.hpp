// What fastens gears, pulleys and couplings to the shaft: the torque that each connection is assessed for, the diameter
// that it is made for, and the rim that it leaves of a gear.
#pragma once

#include "calculators/shaft/design/places.hpp"
#include "lib/calculator/trace.hpp"

namespace loadpath::shaft {

/// The torque of each connection, and the rims of gears.
template <class Tracer>
void judge_connections(const Design::Input& in, Design::Result& r, Tracer& trace);

}  // namespace loadpath::shaft
