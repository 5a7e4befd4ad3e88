#include "lib/mechanism/inverse/group_rows.hpp"

namespace loadpath::mechanism {
namespace {

/// For each row of the full Jacobian and each link: its group, and its index there.
struct Places {
  struct Place {
    std::size_t group = 0, number = 0;
  };
  std::vector<Place> row, link;
};

void list_rows(const Constraints& constraints, GroupRows& group) {
  for (const std::size_t joint : group.joints) {
    const Pair& pair = constraints.pairs()[joint];
    for (std::size_t n = 0; n < pair.shape.rows(); ++n) group.rows.push_back(pair.row + n);
  }
  for (const std::size_t driver : group.drivers) group.rows.push_back(constraints.first_driver_row() + driver);
}

Places places_of(const Constraints& constraints, std::span<const GroupRows> groups) {
  Places places;
  places.row.resize(constraints.rows());
  places.link.resize(constraints.columns() / 3);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t n = 0; n < groups[g].rows.size(); ++n) places.row[groups[g].rows[n]] = {g, n};
    for (std::size_t n = 0; n < groups[g].links.size(); ++n) places.link[groups[g].links[n]] = {g, n};
  }
  return places;
}

}  // namespace

std::vector<GroupRows> rows_of_groups(const Constraints& constraints, std::span<const Group> groups) {
  std::vector<GroupRows> found;
  for (const Group& group : groups) {
    found.push_back({group.links, group.joints, group.drivers, {}, {}, {}});
    list_rows(constraints, found.back());
  }
  const Places places = places_of(constraints, found);
  const auto pattern = constraints.pattern();
  for (std::size_t place = 0; place < pattern.size(); ++place) {
    const auto column = static_cast<std::size_t>(pattern[place].column);
    const auto [group, row] = places.row[static_cast<std::size_t>(pattern[place].row)];
    const auto [of_link, link] = places.link[column / 3];
    if (of_link == group) {
      found[group].own.push_back({place, row, 3 * link + column % 3});
    } else {
      found[group].earlier.push_back({place, row, column});
    }
  }
  return found;
}

}  // namespace loadpath::mechanism
