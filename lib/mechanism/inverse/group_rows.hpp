// The equations of one group: which rows of the Jacobian it has, and what stands in them.
#pragma once

#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/structure/assur.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

struct GroupRows {
  struct Entry {
    std::size_t place;   // in the pattern of the Jacobian
    std::size_t row;     // in this group
    std::size_t column;  // in this group where the link is its own, else in the whole Jacobian
  };
  std::vector<std::size_t> links, joints, drivers;
  std::vector<std::size_t> rows;    // in the whole Jacobian: of the joints, then of the drivers
  std::vector<Entry> own, earlier;  // of the group's links, and of those that it hangs on
};

/// Of all groups, in the order of attachment.
std::vector<GroupRows> rows_of_groups(const Constraints& constraints, std::span<const Group> groups);

}  // namespace loadpath::mechanism
