// The frames of links at a position, the ground's among them.
#pragma once

#include "lib/mechanism/model/pair.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <span>

namespace loadpath::mechanism {

template <class Scalar>
BasicPlaced<Scalar> placed_by(const BasicPose<Scalar>& pose) {
  return {turn(pose.phi), {pose.x, pose.y}, pose.phi};
}

/// The pose of a link, by the poses of all of them; likewise its velocities.
template <class Scalar>
BasicPlaced<Scalar> placed_by(std::span<const BasicPose<Scalar>> poses, int link) {
  return link == ground ? BasicPlaced<Scalar>{} : placed_by(poses[static_cast<std::size_t>(link)]);
}
template <class Scalar>
BasicSpeeds<Scalar> speeds_by(std::span<const BasicPose<Scalar>> velocities, int link) {
  if (link == ground) return {};
  const BasicPose<Scalar>& v = velocities[static_cast<std::size_t>(link)];
  return {{v.x, v.y}, v.phi};
}

inline Placed placed_at(const Position& at, int link) { return placed_by<double>(at.pose, link); }
inline Speeds speeds_at(const Position& at, int link) { return speeds_by<double>(at.velocity, link); }

/// As stated in the model.
inline Placed placed_in(const Model& model, int link) {
  return link == ground ? Placed{} : placed_by(model.links[static_cast<std::size_t>(link)].pose);
}

}  // namespace loadpath::mechanism
