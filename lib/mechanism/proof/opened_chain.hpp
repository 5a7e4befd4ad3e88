// The proof by opening the chain (text D, section 3): enough joints are opened to leave a tree of links. Then, for each
// freedom of each joint of the tree, what acts on the part beyond the joint has no moment about it, or no projection on
// its line; these equations give the reactions in the opened joints and the efforts. The reactions in the joints of the
// tree follow from the equilibrium of the parts.
#pragma once

#include "lib/mechanism/proof/forces.hpp"
#include "lib/mechanism/proof/instant.hpp"

#include <cstddef>
#include <vector>

namespace loadpath::mechanism {

class OpenedChain {
 public:
  /// Opens joints that take away few freedoms rather than others. All links hang together by joints.
  explicit OpenedChain(const Instant& instant);

  void find_forces(const Instant& instant, Forces& forces);

  [[nodiscard]] const std::vector<std::size_t>& opened_joints() const { return opened_; }

 private:
  /// A link with the joint by which it hangs on the tree.
  struct Branch {
    std::size_t link, parent;  // the parent is the ground, or comes earlier
    std::size_t joint;
  };

  void grow_tree(const Constraints& constraints);
  void add_constraints(const Instant& instant);
  void add_active_forces(const Instant& instant);
  void sum_up_parts();
  void write_moments(const Constraints& constraints);
  void solve_moments();
  void find_tree_reactions(const Instant& instant, Forces& forces) const;
  void find_opened_reactions(const Instant& instant, Forces& forces) const;
  [[nodiscard]] const double* acting(std::size_t link, std::size_t column) const;
  [[nodiscard]] const double* on_part(std::size_t link, std::size_t column) const;

  std::size_t links_, rows_;
  std::vector<Branch> branches_;
  std::vector<std::size_t> opened_;
  std::vector<std::size_t> unknowns_;  // rows of the opened joints and of the drivers

  // Force, N, and moment about one point for all links, N times the unit of length.
  std::vector<double> acting_;   // on each link: of a unit of each row's force; then of all active forces
  std::vector<double> on_part_;  // on each link and all beyond it: of a unit of each unknown; then active
  std::vector<double> forces_;   // the unknowns, N

  // An equation for each freedom of the tree; a column for each unknown.
  std::vector<double> moments_, active_moments_;
};

}  // namespace loadpath::mechanism
