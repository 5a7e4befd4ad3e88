// Units of motion and dynamics that no other calculator shows.
#pragma once

#include "lib/quantity/drive_units.hpp"

namespace loadpath {

using Momentum = decltype(Mass() * Speed());
using AngularMomentum = decltype(MassMoment() * AngularSpeed());

inline constexpr Unit<Twist> per_m{"1/m", from_si<Twist>(1.0)};
inline constexpr Unit<Moment> J{"J", from_si<Moment>(1.0), 0, Kind::energy};
inline constexpr Unit<Momentum> kg_m_per_s{"kg*m/s", from_si<Momentum>(1.0)};
inline constexpr Unit<Momentum> N_s{"N*s", from_si<Momentum>(1.0)};
inline constexpr Unit<AngularMomentum> kg_m2_per_s{"kg*m^2/s", from_si<AngularMomentum>(1.0)};

/// Weight per mass where the user gives none: the value of [B32], which the worked examples use.
inline constexpr Acceleration usual_gravity = from_si<Acceleration>(9.81);

}  // namespace loadpath
