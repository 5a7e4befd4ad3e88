// The involute function and its inverse.
#pragma once

namespace loadpath::gear {

/// tan(alpha) - alpha, the polar angle of an involute at the pressure angle alpha, rad.
[[nodiscard]] double involute(double alpha);

/// The pressure angle, rad, whose involute function is the given one; NaN unless that is > 0.
[[nodiscard]] double angle_of_involute(double inv);

}  // namespace loadpath::gear
