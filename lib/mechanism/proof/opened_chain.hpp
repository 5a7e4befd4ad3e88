// The proof by opening the chain (text D, section 3), group after group, the last first: the forces of a group in the
// joints that connect it to earlier ones act on those like any other force.
#pragma once

#include "lib/mechanism/proof/opened_group.hpp"

#include <cstddef>
#include <vector>

namespace loadpath::mechanism {

class OpenedChain {
 public:
  /// All links are connected by joints. The instant is referenced, for its groups.
  explicit OpenedChain(const Instant& instant);

  void find_forces(const Instant& instant, Forces& forces);

  /// The opened joints of all groups, in the order of attachment.
  [[nodiscard]] std::vector<std::size_t> opened_joints() const;

 private:
  std::vector<OpenedGroup> groups_;
  std::vector<double> acting_;  // on the coordinates of all links
};

}  // namespace loadpath::mechanism
