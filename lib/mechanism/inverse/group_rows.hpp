// The equations of one group: its rows of the Jacobian, and their entries.
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
    std::size_t column;  // column in this group if the link is its own, else in the full Jacobian
  };
  std::vector<std::size_t> links, joints, drivers;
  std::vector<std::size_t> rows;    // rows of the full Jacobian: of the joints, then of the drivers
  std::vector<Entry> own, earlier;  // entries of the group's links, and of those that carry it
};

/// The rows of all groups, in the order of attachment.
std::vector<GroupRows> rows_of_groups(const Constraints& constraints, std::span<const Group> groups);

}  // namespace loadpath::mechanism
