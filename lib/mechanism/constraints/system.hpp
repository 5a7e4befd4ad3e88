// Positions, velocities, accelerations, reactions and driving efforts of a planar mechanism, from the equations of
// the full system at once: Newton with the exact constraint Jacobian, and its transpose for the multipliers.
//
// Three coordinates per link (its frame's origin and angle); needs as many independent constraints as coordinates:
// joints + drivers = 3 * links, or mobility 0 without drivers. `diagnose` (structure.hpp) explains violations
// beforehand. All memory is taken in the constructor: `assemble` and `solve` allocate nothing.
#pragma once

#include "lib/mechanism/constraints/gap.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace loadpath::mechanism {

class WholeSystem {
 public:
  /// The model must be consistent (indices in range) and square; it is copied.
  explicit WholeSystem(const Model& model);
  ~WholeSystem();
  WholeSystem(WholeSystem&&) noexcept;

  /// Takes a model of the same structure and of this `characteristic_length`, without springs and friction, as if made
  /// from it; it is to be assembled then.
  void take_dimensions(const Model& model, double length);
  /// Closes the mechanism near the stated poses, at the drivers' coordinates that those poses have.
  Status assemble();
  /// The drivers' coordinates of the position held now (after `assemble` or `move`).
  [[nodiscard]] double coordinate(std::size_t driver) const;
  /// Takes over a position that is closed at these coordinates of the drivers.
  void hold(std::span<const Pose> poses, std::span<const Drive> drives);
  void store_poses(std::span<Pose> poses) const;
  /// Moves from the position held now to these coordinates, in steps small enough to stay in the same assembly.
  Status move(std::span<const Drive> drives);
  /// `move`, then velocities, accelerations, reactions and efforts into `out` (made by `blank`). `statics`: no inertia.
  /// When it fails, `out` and the position held stay as they were.
  Status solve(std::span<const Drive> drives, Position& out, bool statics = false);
  [[nodiscard]] Position blank() const;
  /// For loads that vary over the cycle: the force (in the axes the load has) and the moment from the next `solve` on.
  void set_load(std::size_t load, Vec force, double moment);
  /// After a failure.
  [[nodiscard]] Gap gap() const;
  /// Reciprocal condition number (1-norm estimate) of the constraint equations of the position held now.
  [[nodiscard]] double condition() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace loadpath::mechanism
