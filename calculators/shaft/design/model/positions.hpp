// The positions of a turn at which the loads of a shaft are known.
#pragma once

#include "calculators/shaft/design/model/input.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>

namespace loadpath::shaft {

/// Any series among the loads of mounted components and their angle; null for constant loads.
const Value* any_series(const DesignInput& in);
/// 1 where nothing varies.
std::size_t positions_of(const DesignInput& in);
bool varies(const DesignInput& in);
bool torque_varies(const DesignInput& in);
/// The share of the turn's time that belongs to a position.
double share_of(const DesignInput& in, std::size_t position);
/// Angle of the shaft; 0 if no mounted component gives it.
double psi_of(const DesignInput& in, std::size_t position);

/// Revolutions of the shaft over all positions, signed; 0 if it oscillates or is at rest.
double turns_of(const DesignInput& in);

/// Fault in the loads over a revolution; empty: none.
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

/// Speed of the shaft, or of the first mounted component that has one; its magnitude.
AngularSpeed speed_of(const DesignInput& in);
/// Torque of the mounted component on the shaft at a position: positive if it drives.
Moment torque_of(const DesignInput& in, std::size_t seat, std::size_t position);

}  // namespace loadpath::shaft
