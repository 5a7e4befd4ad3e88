// The standard acceleration of free fall.
#pragma once

namespace loadpath {

inline constexpr double standard_gravity = 9.80665;  // m/s^2, CGPM 1901

}  // namespace loadpath
