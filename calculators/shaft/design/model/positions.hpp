// The positions of a turn at which the loads of a shaft are known.
#pragma once

#include "calculators/shaft/design/model/input.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>

namespace loadpath::shaft {

/// Of the loads of seats and their angle any series; null where nothing varies.
const Value* any_series(const DesignInput& in);
/// 1 where nothing varies.
std::size_t positions_of(const DesignInput& in);
bool varies(const DesignInput& in);
bool torque_varies(const DesignInput& in);
/// The share of the turn's time that belongs to a position.
double share_of(const DesignInput& in, std::size_t position);
/// Angle of the shaft; 0 where no seat tells it.
double psi_of(const DesignInput& in, std::size_t position);

/// How often the shaft turns over all positions, signed; 0 where it swings or stands.
double turns_of(const DesignInput& in);

/// What may be wrong with loads over a turn; empty: nothing.
struct TurnFault {
  const char* key = "";
  Message message, hint;
};
TurnFault fault_of_turn(const DesignInput& in);

/// Calls with each of the loads of a seat.
template <class Take>
void for_each_load(const Seat& seat, const Take& take) {
  take("T", seat.T), take("F_x", seat.F_x), take("F_y", seat.F_y), take("F_z", seat.F_z);
}

/// Of the shaft, or the first seat that has one; its magnitude.
AngularSpeed speed_of(const DesignInput& in);
/// What the seat gives to the shaft at a position: positive where it drives.
Moment torque_of(const DesignInput& in, std::size_t seat, std::size_t position);

}  // namespace loadpath::shaft
