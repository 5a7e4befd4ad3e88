// The motion of a point of a rigid link, from that of the link's frame. `arm`: from its origin, global axes.
#pragma once

#include "lib/mechanism/model/model.hpp"

namespace loadpath::mechanism {

template <class Scalar>
constexpr BasicVec<Scalar> point_velocity(const BasicPose<Scalar>& velocity, BasicVec<Scalar> arm) {
  return BasicVec<Scalar>{velocity.x, velocity.y} + velocity.phi * normal(arm);
}

template <class Scalar>
constexpr BasicVec<Scalar> point_acceleration(const BasicPose<Scalar>& acceleration, std::type_identity_t<Scalar> omega,
                                              BasicVec<Scalar> arm) {
  return BasicVec<Scalar>{acceleration.x, acceleration.y} + acceleration.phi * normal(arm) - omega * omega * arm;
}

}  // namespace loadpath::mechanism
