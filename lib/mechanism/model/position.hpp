// The results of a solver at one position of a mechanism.
#pragma once

#include "lib/mechanism/model/model.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// The state of one driver: coordinate, speed, acceleration (rad or m, per s, per s^2). If all drivers rest,
/// `impending` is the direction of impending motion: +1 or -1, 0: unknown.
struct Drive {
  double coordinate = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
  double impending = 0.0;
};

/// Whether some driver moves.
inline bool moves(std::span<const Drive> drives) {
  return std::any_of(drives.begin(), drives.end(), [](const Drive& d) { return d.speed != 0.0; });
}

/// Force and couple that link j exerts on link i, global axes, at the joint's pin (point_i of link i).
template <class Scalar>
struct BasicReaction {
  BasicVec<Scalar> at;               // global
  BasicVec<Scalar> force;            // N
  Scalar couple = 0.0;               // N m; fixes the angle, or is friction
  double touch = Profile::anywhere;  // cams: where on the profile (BasicTouch::parameter)
};
using Reaction = BasicReaction<double>;

/// A load as it is at a position: loads may vary over the cycle.
struct LoadNow {
  Vec force;            // N, in the axes that the load has
  double moment = 0.0;  // N m
};

/// Everything at one position. Vectors are as long as the model's links, joints, drivers, loads.
struct Position {
  std::vector<Pose> pose;
  std::vector<Pose> velocity;      // m/s, rad/s
  std::vector<Pose> acceleration;  // m/s^2, rad/s^2
  std::vector<Pose> tendency;      // mechanisms with friction: the velocity, or that of the impending motion
  std::vector<Reaction> reactions;
  std::vector<double> effort;  // N m or N, on link i of the driver
  std::vector<LoadNow> loads;
};

/// A position of this model with room for everything, so that solving one allocates nothing.
inline Position blank_position(const Model& model) {
  Position position;
  for (auto* poses : {&position.pose, &position.velocity, &position.acceleration, &position.tendency})
    poses->resize(model.links.size());
  position.reactions.resize(model.joints.size());
  position.effort.resize(model.drivers.size());
  for (const Load& load : model.loads) position.loads.push_back({load.force, load.moment});
  return position;
}

/// `jams`: it moves so, but friction grows with the force of the drive and no force is enough; the motion is given, the
/// forces are not.
enum class Status { closed, does_not_close, singular, jams };

}  // namespace loadpath::mechanism
