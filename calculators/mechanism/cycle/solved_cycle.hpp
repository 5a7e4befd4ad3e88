// The solved positions of a mechanism.
#pragma once

#include "calculators/mechanism/cycle/between.hpp"
#include "calculators/mechanism/cycle/equilibrium.hpp"
#include "lib/mechanism/groups/released_system.hpp"
#include "lib/mechanism/proof/proof.hpp"
#include "lib/mechanism/structure/release.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace loadpath::planar {

/// In the place of a number that is not known, or that there is not.
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The effort of a drive without inertia that starts the mechanism from rest, and the effort that balances it without
/// friction, N m or N. NaN there: no effort starts it in that direction.
struct StandingEffort {
  double backward = none, without = none, forward = none;
  bool known = false;  // the position was reached

  /// Whether it stays at rest without its drive.
  [[nodiscard]] bool stands() const { return known && !(backward > 0.0) && !(forward < 0.0); }
};

/// The solved positions. Where the mechanism does not close there is none.
struct Cycle {
  std::vector<mechanism::Position> positions;
  std::vector<std::vector<mechanism::Drive>> drives;  // with which they are solved
  std::vector<mechanism::Proof> proofs;
  std::vector<double> largest_reactions;  // of each position, if all have forces; empty: not found yet
  std::vector<bool> closed;
  bool returns = true;  // after a full revolution, to its start
  /// By how much a turning spring is wound up then, rad.
  struct Winding {
    std::size_t spring = 0;
    double by = 0.0;
  };
  std::vector<Winding> windings;
  std::vector<bool> at_change_point;  // not closed: the drives do not hold it there; what lies beyond is solved
  std::vector<bool> in_steps;         // closed, followed from the position before in small steps
  std::vector<bool> jams;             // closed, but friction lets no drive move it: it has no forces there
  std::vector<bool> undirected;       // closed, but the ends of a spring coincide: its force has no direction there
  std::vector<bool> some_rest;        // joints with friction: as at a dead point, or all joints
  /// There, with friction of resting parts in either direction; empty if friction prevents that motion.
  std::vector<std::vector<mechanism::Position>> either_way;
  std::vector<StandingEffort> standing;  // with friction and one drive
  /// The minimum friction that keeps it at rest under its load without its drive: somewhere, and at every position.
  struct Threshold {
    double share = 0.0;  // share of its friction
    std::size_t at = 0;
  };
  std::optional<Threshold> stands_somewhere, stands_everywhere;
  Between between;        // features between the requested positions
  Equilibria equilibria;  // the positions, where the analysis is of equilibrium
  mechanism::Status first_failure = mechanism::Status::closed;
  mechanism::Gap gap;                         // at the first failure
  double worst_condition = 0.0;               // largest condition number of the constraints; 0: no position is closed
  std::size_t worst_at = 0;                   // where that is
  std::vector<mechanism::Uniqueness> unique;  // uniqueness of each joint's reaction; empty where all are

  [[nodiscard]] bool has_forces(std::size_t k) const { return closed[k] && !jams[k] && !undirected[k]; }
  /// Whether it is solved everywhere but where it hits a change point.
  [[nodiscard]] bool closes_but_at_change_points() const {
    for (std::size_t k = 0; k < closed.size(); ++k) {
      if (!closed[k] && !at_change_point[k]) return false;
    }
    return true;
  }
};

}  // namespace loadpath::planar
