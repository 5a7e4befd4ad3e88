// Connections of gears, pulleys and couplings to the shaft: the torque that each is assessed for, its diameter, and
// the remaining rim of a gear.
#pragma once

#include "calculators/shaft/design/model/input.hpp"
#include "calculators/shaft/design/model/result.hpp"
#include "lib/calculator/trace.hpp"

#include <cstddef>

namespace loadpath::shaft {

/// The thinner of two pieces that meet under a seat, and of a taper what its middle has.
Length diameter_under(const DesignInput& in, Length x);
inline Length diameter_under(const DesignInput& in, const Seat& seat) { return diameter_under(in, seat.x); }
/// Whether torque passes between the shaft and what sits there, and they are two pieces.
bool needs_connection(const DesignInput& in, std::size_t seat);
/// Whether the seat is a separate hub with a root circle.
bool has_rim(const Seat& seat);

/// The torque of each connection, and the rims of gears.
template <class Tracer>
void judge_connections(const DesignInput& in, DesignResult& r, Tracer& trace);

}  // namespace loadpath::shaft
