// Positions, velocities, accelerations, reactions and driving efforts of a planar mechanism, from the equations of the
// whole system at once: Newton with the exact constraint Jacobian, and its transpose for the multipliers.
//
// Three coordinates per link (its frame's origin and angle); needs as many independent constraints as coordinates:
// joints + drivers = 3 * links, or mobility 0 without drivers. `diagnose` (structure.hpp) says so in words beforehand.
// All memory is taken in the constructor: `assemble` and `solve` allocate nothing.
#pragma once

#include "lib/mechanism/model.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// The state of one driver: coordinate, speed, acceleration (rad or m, per s, per s^2).
struct Drive {
  double coordinate = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
};

/// Force and couple that link j exerts on link i, global axes, at the joint's pin (point_i of link i).
struct Reaction {
  Vec at;             // global
  Vec force;          // N
  double couple = 0;  // N m; prismatic only
};

/// Everything at one position. Vectors are as long as the model's links, joints, drivers.
struct Position {
  std::vector<Pose> pose;
  std::vector<Pose> velocity;      // m/s, rad/s
  std::vector<Pose> acceleration;  // m/s^2, rad/s^2
  std::vector<Reaction> reactions;
  std::vector<double> effort;    // N m or N, on link i of the driver
  double residual_force = 0.0;   // largest unbalanced force on a link, N, by summing what acts on it
  double residual_moment = 0.0;  // largest unbalanced moment about a link's mass centre, N m
  double power_residual = 0.0;   // drives + loads + gravity - rate of kinetic energy, W
  double power_scale = 0.0;      // sum of the magnitudes in the power balance, W
};

enum class Status { closed, does_not_close, singular };

class WholeSystem {
 public:
  /// The model must be consistent (indices in range) and square; it is copied.
  explicit WholeSystem(const Model& model);
  ~WholeSystem();
  WholeSystem(WholeSystem&&) noexcept;

  /// Closes the mechanism near the stated poses, at the drivers' coordinates that those poses have.
  Status assemble();
  /// The drivers' coordinates of the position held now (after `assemble` or `move`).
  [[nodiscard]] double coordinate(std::size_t driver) const;
  /// Moves from the position held now to these coordinates, in steps small enough to stay in the same assembly.
  Status move(std::span<const Drive> drives);
  /// `move`, then velocities, accelerations, reactions and efforts into `out` (made by `blank`). `statics`: no inertia.
  /// When it fails, `out` and the position held stay as they were.
  Status solve(std::span<const Drive> drives, Position& out, bool statics = false);
  [[nodiscard]] Position blank() const;
  /// For loads that vary over the cycle: the force (in the axes the load has) and the moment from the next `solve` on.
  void set_load(std::size_t load, Vec force, double moment);
  /// After a failure: the joint that stays open widest when the mechanism is pulled together as far as it goes, and the
  /// part of the last `move`, 0 to 1, up to which it closes.
  struct Gap {
    int joint = -1;
    double size = 0.0;  // m
    double reached = 0.0;
  };
  [[nodiscard]] Gap gap() const;
  /// Reciprocal condition number (1-norm estimate) of the constraint equations of the position held now.
  [[nodiscard]] double condition() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace loadpath::mechanism
