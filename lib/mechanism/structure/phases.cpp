#include "lib/mechanism/structure/phases.hpp"

#include "lib/mechanism/model/pair.hpp"
#include "lib/mechanism/structure/free_mechanism.hpp"

#include <cstddef>
#include <set>
#include <vector>

namespace loadpath::mechanism {

namespace {

std::vector<std::size_t> phase_rows(const Constraints& constraints) {
  std::vector<std::size_t> rows;
  for (const Pair& pair : constraints.pairs()) {
    if (has_phase(pair.shape)) rows.push_back(pair.row);
  }
  return rows;
}

/// The angles of the links that carry wheels: 3 coordinates a link, the ground has none.
std::vector<std::size_t> wheel_angles(const Constraints& constraints) {
  std::set<std::size_t> angles;
  for (const Pair& pair : constraints.pairs()) {
    if (!has_phase(pair.shape)) continue;
    for (const std::size_t link : {pair.i, pair.j}) {
      if (3 * link < constraints.columns()) angles.insert(3 * link + 2);
    }
  }
  return {angles.begin(), angles.end()};
}

}  // namespace

void settle_phases(Model& model) {
  take_phases(model);
  const double length = characteristic_length(model);
  FreeMechanism free(in_unit_of_length(model, length));
  const std::vector<std::size_t> rows = phase_rows(free.constraints());
  if (rows.empty() || !free.close_without(rows, wheel_angles(free.constraints()))) return;
  const std::vector<Pose> poses = free.poses(length);
  for (std::size_t k = 0; k < poses.size(); ++k) model.links[k].pose = poses[k];
  take_phases(model);
}

}  // namespace loadpath::mechanism
