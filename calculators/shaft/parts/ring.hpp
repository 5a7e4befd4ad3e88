// A section of a round part, solid or bored, and how steep a cone may be.
#pragma once

#include "lib/quantity/units.hpp"

namespace loadpath::shaft {

struct Ring {
  Length d, d_bore;
};

inline SecondMoment polar(const Ring& r) {
  return pi / 32.0 * (r.d - r.d_bore) * (r.d + r.d_bore) * (r.d * r.d + r.d_bore * r.d_bore);
}

/// Up to a half-angle of 10 degrees a cone is taken for slender: the stress of torsion at its surface is 1 % above the
/// exact one, [Foeppl], that of bending in a wedge of the same angle 2 % at most.
inline constexpr double steepest_cone = 0.176;

}  // namespace loadpath::shaft
