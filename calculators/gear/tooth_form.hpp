// The form of a tooth with outer teeth as a rack with rounded corners generates it: flank, fillet, weakest section.
//
// Lengths in modules. Coordinates of the gear: y runs from the axis through the middle of a tooth, x across it.
#pragma once

#include "calculators/gear/rack.hpp"

namespace loadpath::gear {

struct FormPoint {
  double x = 0.0;  // half the thickness of the tooth
  double y = 0.0;  // from the axis
};

/// The point of the fillet whose contact normal leans by `lean` rad from the middle of the space: 0 at the root,
/// pi/2 - alpha at the flank.
[[nodiscard]] FormPoint fillet_point(const Rack& rack, double z, double x, double lean);

/// Half the angle of the tooth, rad, at the radius r >= the base radius.
[[nodiscard]] double half_angle(double alpha, double z, double x, double r);

/// The radius that the straight flank of the rack reaches down to: where the fillet begins.
[[nodiscard]] double form_radius(const Rack& rack, double z, double x);

}  // namespace loadpath::gear
