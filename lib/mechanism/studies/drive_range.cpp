#include "lib/mechanism/studies/drive_range.hpp"

#include "lib/mechanism/groups/system.hpp"

namespace loadpath::mechanism {
namespace {

/// The share of a way that can be gone, 1 if all of it: a move ends where its steps become too small to go on, some
/// 1e-9 of the way before the singular position.
double share_gone(GroupSystem& system, const Drive& from, double way, Position& out) {
  const Drive goal{from.coordinate + way, 0.0, 0.0};
  const Status status = system.solve({&goal, 1}, out, true);
  const bool gone = status == Status::closed || status == Status::jams;
  return gone ? 1.0 : system.gap().reached;
}

}  // namespace

std::optional<DriveRange> drive_range(const Model& model, double down, double up) {
  GroupSystem system(model);
  if (system.assemble() != Status::closed) return std::nullopt;
  DriveRange range{.assembled = system.coordinate(0)};
  const Drive from{range.assembled, 0.0, 0.0};
  Position out = blank_position(model);
  if (up > 0.0) {
    const double share = share_gone(system, from, up, out);
    if (share < 1.0) range.most = from.coordinate + share * up;
  }
  GroupSystem again(model);  // from the stated assembly: the first one may have been moved
  if (down > 0.0 && again.assemble() == Status::closed) {
    const double share = share_gone(again, from, -down, out);
    if (share < 1.0) range.least = from.coordinate - share * down;
  }
  return range;
}

}  // namespace loadpath::mechanism
