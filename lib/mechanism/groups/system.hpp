// Positions, velocities, accelerations, reactions and driving efforts of a planar mechanism, group by group: forward
// through the initial links and Assur groups in their order of attachment, back for the forces. The cost is linear in
// the number of groups. Moves that the groups cannot follow by themselves, a change point or a long move, are
// followed by the equations of the full system (lib/mechanism/constraints), which also give the reason why a position
// is not reached.
//
// The model has passed `diagnose`. All memory is taken in the constructor: `assemble` and `solve` allocate nothing.
#pragma once

#include "lib/mechanism/constraints/system.hpp"
#include "lib/mechanism/forces/induced_source.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace loadpath::mechanism {

struct Chain;

class GroupSystem {
 public:
  explicit GroupSystem(const Model& model);
  ~GroupSystem();
  GroupSystem(GroupSystem&&) noexcept;
  /// Takes a model of the same structure, as if made from it. Allocates nothing if the mechanism is a chain of
  /// drives and dyads without springs and friction. It is to be assembled then.
  void take_dimensions(const Model& model);

  /// Closes the mechanism near the stated poses, at the drivers' coordinates that those poses have.
  Status assemble();
  /// Takes over a position that is closed at these coordinates of the drivers.
  Status hold(std::span<const Pose> poses, std::span<const Drive> drives);
  /// The drivers' coordinates of the position held now.
  [[nodiscard]] double coordinate(std::size_t driver) const;
  /// Moves from the position held now to these coordinates without leaving the assembly, then fills `out` (made by
  /// `blank_position`). `statics`: no inertia. When it fails, `out` and the position held stay as they were.
  Status solve(std::span<const Drive> drives, Position& out, bool statics = false);
  /// The same without forces: poses, velocities, accelerations.
  Status solve_motion(std::span<const Drive> drives, Position& out);
  /// Whether the last `solve` had to follow the mechanism in small steps: near a change point, or over a long move.
  [[nodiscard]] bool followed_in_steps() const;
  /// Friction of joints that rest while others move, and the factor on all dry friction and losses; from the next
  /// `solve` on.
  void take_friction(FrictionTaken taken);
  /// Whether at the last `solve` a joint with friction did not move, nor was about to.
  [[nodiscard]] bool some_joint_rests() const;
  /// For loads that vary over the cycle: the force (in the axes the load has) and the moment from the next `solve` on.
  void set_load(std::size_t load, Vec force, double moment);
  /// The mechanism as a chain of drives and dyads, if it is one; on which sides these are assembled now, step by step.
  [[nodiscard]] const Chain* chain() const;
  [[nodiscard]] std::span<const double> sides() const;
  /// The largest change of a drive in a move, rad or parts of the mechanism's size; NaN if one of them is.
  [[nodiscard]] double change(std::span<const Drive> from, std::span<const Drive> to) const;
  /// After a failure, as WholeSystem::gap.
  [[nodiscard]] Gap gap() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace loadpath::mechanism
