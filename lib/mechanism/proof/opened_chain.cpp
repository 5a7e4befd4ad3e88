#include "lib/mechanism/proof/opened_chain.hpp"

#include <algorithm>

namespace loadpath::mechanism {

OpenedChain::OpenedChain(const Instant& instant) : acting_(instant.constraints().columns()) {
  for (const GroupRows& group : instant.inverse().groups()) groups_.emplace_back(instant, group);
}

void OpenedChain::find_forces(const Instant& instant, Forces& forces) {
  std::ranges::fill(acting_, 0.0);
  add_up(instant.active(), instant.length(), acting_);
  for (auto group = groups_.rbegin(); group != groups_.rend(); ++group) group->find_forces(instant, acting_, forces);
}

std::vector<std::size_t> OpenedChain::opened_joints() const {
  std::vector<std::size_t> joints;
  for (const OpenedGroup& group : groups_) {
    joints.insert(joints.end(), group.opened_joints().begin(), group.opened_joints().end());
  }
  return joints;
}

}  // namespace loadpath::mechanism
