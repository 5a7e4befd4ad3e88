// How a point of a rigid link moves, by the motion of the link's frame. `arm`: from the frame's origin, global axes.
#pragma once

#include "lib/mechanism/model.hpp"

namespace loadpath::mechanism {

constexpr Vec point_velocity(const Pose& velocity, Vec arm) {
  return Vec{velocity.x, velocity.y} + velocity.phi * normal(arm);
}

constexpr Vec point_acceleration(const Pose& acceleration, double omega, Vec arm) {
  return Vec{acceleration.x, acceleration.y} + acceleration.phi * normal(arm) - omega * omega * arm;
}

}  // namespace loadpath::mechanism
