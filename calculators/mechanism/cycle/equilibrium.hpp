// Positions of equilibrium that were found: where they are, and whether the mechanism returns to them.
#pragma once

#include <limits>
#include <vector>

namespace loadpath::planar {

/// After a small displacement the mechanism returns, moves away, moves away to one side only, or stays.
enum class Stability { stable, unstable, one_sided, neutral };

struct Equilibrium {
  double place = 0.0;      // among the positions, as schedule_of takes it
  double stiffness = 0.0;  // derivative of the effort that holds it by the coordinate of the drive, N m/rad or N/m
  Stability stability = Stability::neutral;
};

struct Equilibria {
  std::vector<Equilibrium> found;  // in the order of the positions
  bool everywhere = false;         // nothing moves the mechanism at any position
  /// The smallest effort that is needed to hold it, N m or N, with its sign, and the place on the axis.
  double least = std::numeric_limits<double>::quiet_NaN(), least_at = 0.0;
};

}  // namespace loadpath::planar
