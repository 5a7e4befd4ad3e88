// Derivatives of the position functions of a mechanism: the motion of every link per radian or metre of a drive, at
// any speed. Also called velocity and acceleration analogues.
#pragma once

#include "lib/mechanism/groups/motion.hpp"
#include "lib/mechanism/groups/plan.hpp"
#include "lib/mechanism/groups/positions.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <vector>

namespace loadpath::mechanism {

class PositionFunctions {
 public:
  /// The model has passed `diagnose`; it is referred to.
  explicit PositionFunctions(const Model& model);
  PositionFunctions(const PositionFunctions&) = delete;
  PositionFunctions& operator=(const PositionFunctions&) = delete;

  /// From the poses of `at`, an assembly, its velocities and accelerations as the first and second derivatives with
  /// respect to a drive's coordinate, the others holding still: rad and m per rad, or per m. False if the drives
  /// cannot hold the mechanism.
  [[nodiscard]] bool derive(Position& at, std::size_t driver = 0);
  /// The sign of the determinant of a group's closing equations, in order of attachment, where it was derived last:
  /// +1 or -1. It changes where the group passes from one of its assemblies to another.
  [[nodiscard]] double sign(std::size_t group) { return positions_.loops(group).sign(); }
  [[nodiscard]] const Plan& plan() const { return plan_; }

 private:
  const Model& model_;
  Plan plan_;
  GroupPositions positions_;
  GroupMotion motion_;
  std::vector<Drive> drives_;
};

/// The same of the only drive of a solved position, from its velocities and accelerations: the drive has constant
/// speed.
void divide_by_speed(Position& at, double speed);

/// The coordinate of a drive at these poses, rad or m.
double drive_coordinate(const Model& model, std::size_t driver, const Position& at);

}  // namespace loadpath::mechanism
