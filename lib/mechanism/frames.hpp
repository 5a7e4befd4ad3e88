// The frames of links at a position, the ground's among them.
#pragma once

#include "lib/mechanism/pair.hpp"
#include "lib/mechanism/position.hpp"

#include <cstddef>

namespace loadpath::mechanism {

inline Placed placed_at(const Position& at, int link) {
  if (link == ground) return {};
  const Pose& pose = at.pose[static_cast<std::size_t>(link)];
  return {turn(pose.phi), {pose.x, pose.y}, pose.phi};
}

inline Speeds speeds_at(const Position& at, int link) {
  if (link == ground) return {};
  const Pose& v = at.velocity[static_cast<std::size_t>(link)];
  return {{v.x, v.y}, v.phi};
}

}  // namespace loadpath::mechanism
