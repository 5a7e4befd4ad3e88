// The opened chain of one group: enough of its joints are opened to leave a tree of its links, connected to the
// ground and to earlier groups. Then, for each degree of freedom of each joint of the tree, the loads on the part
// beyond the joint have no moment about it, or no projection on its line; these equations give the reactions in the
// opened joints and the efforts. The reactions in the joints of the tree follow from the equilibrium of the parts.
#pragma once

#include "lib/mechanism/inverse/group_rows.hpp"
#include "lib/mechanism/proof/forces.hpp"
#include "lib/mechanism/proof/instant.hpp"
#include "lib/numerics/dense_inverse.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// On a link: a force, N, and a moment about the origin of its frame, N times the unit of length.
using Acting = std::array<double, 3>;

class OpenedGroup {
 public:
  /// The group's rows are referred to. Opens joints that take away few freedoms rather than others.
  OpenedGroup(const Instant& instant, const GroupRows& group);

  /// From the loads on the coordinates of all links (`add_up`), later groups included: the reactions in its joints
  /// and the efforts of its drivers; adds its forces on earlier links.
  void find_forces(const Instant& instant, std::span<double> on_links, Forces& forces);

  [[nodiscard]] const std::vector<std::size_t>& opened_joints() const { return opened_; }

 private:
  /// A joint of the group, by the places of its links in it.
  struct Joining {
    std::size_t joint, row;
    std::size_t i, j;  // `outside` for the ground and for links of earlier groups
  };
  /// A link with the joint that connects it to the tree.
  struct Branch {
    std::size_t link, parent;  // the parent is outside, or comes earlier
    std::size_t joining;
  };

  void list_joinings(const Instant& instant);
  void grow_tree(const Constraints& constraints);
  void add_constraints(const Instant& instant);
  void add_active_forces(const Instant& instant, std::span<const double> on_links);
  void sum_up_parts();
  void write_moments(const Constraints& constraints);
  void solve_moments();
  void find_tree_reactions(const Instant& instant, Forces& forces) const;
  void find_opened_reactions(const Instant& instant, Forces& forces) const;
  void find_efforts(const Instant& instant, Forces& forces) const;
  void press_on_earlier(const Instant& instant, std::span<double> on_links, const Forces& forces) const;
  [[nodiscard]] Acting& acting(std::size_t link, std::size_t column) { return acting_[column * links_ + link]; }
  [[nodiscard]] const Acting& acting(std::size_t link, std::size_t column) const {
    return acting_[column * links_ + link];
  }
  [[nodiscard]] const Acting& on_part(std::size_t link, std::size_t column) const {
    return on_part_[column * links_ + link];
  }
  /// From the origin of the group's first link, about which its moments are taken.
  [[nodiscard]] Vec from_first(const Instant& instant, std::size_t link) const;

  const GroupRows* group_;
  std::size_t links_, rows_, outside_;
  std::vector<Joining> joinings_;
  std::vector<Branch> branches_;
  std::vector<std::size_t> opened_;    // joints
  std::vector<std::size_t> unknowns_;  // rows of the opened joints and of the drivers

  std::vector<Acting> acting_;   // on each link: of a unit of each row's force; then of all active forces
  std::vector<Acting> on_part_;  // on each link and all beyond it: of a unit of each unknown; then active

  // An equation for each freedom of the tree; a column for each unknown.
  numerics::DenseInverse inverse_;
  std::vector<double> moments_, active_moments_;
  std::vector<double> forces_;  // the unknowns, N
};

}  // namespace loadpath::mechanism
