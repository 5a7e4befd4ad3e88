// The proof by opening the chain (text D, section 3), group after group, the last first: what a group presses with in
// the joints by which it hangs on earlier ones acts on those like any other force.
#pragma once

#include "lib/mechanism/proof/opened_group.hpp"

#include <cstddef>
#include <vector>

namespace loadpath::mechanism {

class OpenedChain {
 public:
  /// All links hang together by joints. The instant is referred to, for the groups that it goes by.
  explicit OpenedChain(const Instant& instant);

  void find_forces(const Instant& instant, Forces& forces);

  /// The opened joints of all groups, in the order of attachment.
  [[nodiscard]] std::vector<std::size_t> opened_joints() const;

 private:
  std::vector<OpenedGroup> groups_;
  std::vector<double> acting_;  // on the coordinates of all links
};

}  // namespace loadpath::mechanism
