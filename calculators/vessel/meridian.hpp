// A meridian given by points: its tangents and curvatures by circles through three neighbours, which are exact for the
// arcs and straight lines that vessels are made of, and the forces of gas and liquid on what lies before each point.
#pragma once

#include "calculators/vessel/membrane.hpp"
#include "lib/calculator/list.hpp"

namespace loadpath::vessel {

inline constexpr std::size_t most_points = 64;

struct MeridianPoint {
  double r = 0.0, z = 0.0;         // m, middle of the carrying wall
  double sine = 0.0;               // sine of the angle between the outward normal and the axis
  double kappa = 0.0;              // 1/m, positive where the shell bulges
  double turn = 0.0;               // rad, between the neighbouring chords
  double gas = 0.0, liquid = 0.0;  // m^2 and N: axial force on what lies before the point, over 2 pi and 2 pi p
};
using Meridian = List<MeridianPoint, most_points>;

struct Free {
  bool closed = true;  // end of the shell at its first point, if that is not on the axis
};

/// From the points as given, moved outward by e. `rho_g` is the weight of the liquid per volume, 0 without one.
Meridian meridian(Meridian points, double e, Free start, double rho_g, double surface);

}  // namespace loadpath::vessel
