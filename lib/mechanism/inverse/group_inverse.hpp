// The inverse of the constraints' Jacobian, group after group. The constraints of a group act on its own links and
// earlier ones, so the Jacobian is block triangular, and the inverses of the groups suffice: the work grows with the
// number of groups, and not with its cube.
#pragma once

#include "lib/mechanism/inverse/group_rows.hpp"
#include "lib/numerics/dense_inverse.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

class GroupInverse {
 public:
  /// Accepts any mechanism, so that its results can be listed before its structure is known to be sound.
  GroupInverse(const Constraints& constraints, std::span<const Group> groups);
  /// In the order of attachment.
  [[nodiscard]] std::span<const GroupRows> groups() const { return groups_; }

  /// At the position of the constraints; every group has as many rows as its links have coordinates. The inverse of a
  /// singular Jacobian holds no finite numbers. Takes no memory.
  void invert(const Constraints& constraints);

  /// The motion of all links, coordinate by coordinate, when the constraints yield at these rates, which are
  /// overwritten: J motion = rates. None yields before this group: earlier links are at rest.
  void find_motion(std::span<double> rates, std::span<double> motion, std::size_t first_group = 0) const;
  /// The constraint forces against the loads along the coordinates, which are overwritten: J^T supply = acting. The
  /// last group is first: each constraint by the power of the loads on the links of its group when only it is
  /// released, where forces from later groups count as loads.
  void find_supply(std::span<double> acting, std::span<double> supply) const;

  /// Condition number, 1-norm, at least 1. Above twenty links it is estimated, at times slightly too small. Not
  /// finite if singular.
  [[nodiscard]] double condition();

 private:
  struct Block {
    explicit Block(std::size_t size) : inverse(size), motions(size * size) {}
    numerics::DenseInverse inverse;
    std::vector<double> motions;  // motions of the group's links for each of its rows
  };

  [[nodiscard]] double norm();
  [[nodiscard]] double norm_of_inverse();
  [[nodiscard]] double estimated_norm_of_inverse();

  std::vector<GroupRows> groups_;
  std::vector<numerics::MatrixEntry> pattern_;
  std::vector<double> jacobian_;
  std::vector<Block> blocks_;
  std::vector<double> probe_, rates_;
};

}  // namespace loadpath::mechanism
