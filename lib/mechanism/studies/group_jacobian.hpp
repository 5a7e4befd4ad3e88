// The determinant of the closing equations of each group, the Jacobian of [D3]: every reaction of the group is a
// quotient with J below it, so where J vanishes the group is at a singular position.
#pragma once

#include "lib/mechanism/groups/plan.hpp"
#include "lib/mechanism/groups/positions.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <span>

namespace loadpath::mechanism {

/// Its magnitude is the same for every choice of the loops, of absolute or relative coordinates, and of the equations
/// of motion or of equilibrium, as long as these are of unit forces and moments; its sign depends on their order.
class GroupJacobians {
 public:
  /// The model has passed `diagnose`.
  explicit GroupJacobians(const Model& model);
  GroupJacobians(const GroupJacobians&) = delete;
  GroupJacobians& operator=(const GroupJacobians&) = delete;

  /// Takes over an assembly.
  void take(std::span<const Pose> poses);
  /// The magnitude in the assembly taken, in m to the power of `metres`; 0 at a change point, 1 if the group has no
  /// unknown coordinate.
  [[nodiscard]] double magnitude(std::size_t group);
  /// Lengths among its equations, less those among its coordinates.
  [[nodiscard]] int metres(std::size_t group) const;
  /// Groups in order of attachment, as `groups` lists them.
  [[nodiscard]] const Plan& plan() const { return plan_; }

 private:
  Plan plan_;
  GroupPositions positions_;
};

}  // namespace loadpath::mechanism
