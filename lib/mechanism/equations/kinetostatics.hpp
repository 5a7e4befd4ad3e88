// Forces at one position: those that the constraints must supply, and their distribution to the joints.
#pragma once

#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/point_motion.hpp"
#include "lib/mechanism/model/position.hpp"

#include <span>

namespace loadpath::mechanism {

/// A force and a moment on a link, about its frame's origin.
template <class Scalar>
struct BasicWrench {
  BasicVec<Scalar> force;  // N
  Scalar moment = 0.0;     // N m
  /// Adds a wrench about another origin, at `lever` from this one.
  void add(const BasicWrench& other, BasicVec<Scalar> lever) {
    force = force + other.force;
    moment += other.moment + cross(lever, other.force);
  }
  void subtract(const BasicWrench& other) {
    force = force - other.force;
    moment -= other.moment;
  }
};
using Wrench = BasicWrench<double>;

/// The pose of a link: its frame's origin and its rotation.
template <class Scalar>
struct BasicAcceleration {
  BasicVec<Scalar> origin;  // m/s^2
  Scalar omega = 0.0, epsilon = 0.0;
};
using Acceleration = BasicAcceleration<double>;

/// The wrench needed to move a link in this manner, m a and J epsilon, less its weight.
template <class Scalar>
BasicWrench<Scalar> inertia_less_weight(const BasicLink<Scalar>& link, const BasicTurn<Scalar>& turned,
                                        const BasicAcceleration<Scalar>& a, BasicVec<Scalar> gravity) {
  const BasicVec<Scalar> arm = turned(link.centre);
  const BasicVec<Scalar> centre = point_acceleration({a.origin.x, a.origin.y, a.epsilon}, a.omega, arm);
  const BasicVec<Scalar> force = link.mass * (centre - gravity);
  return {force, link.inertia * a.epsilon + cross(arm, force)};
}

template <class Scalar>
BasicWrench<Scalar> wrench_of(const BasicLoad<Scalar>& load, const BasicTurn<Scalar>& turned) {
  const BasicVec<Scalar> force = global_force(load, load.force, turned);
  return {force, load.moment + cross(turned(load.point), force)};
}

/// Inertia less loads and gravity, per coordinate: the right side of the transposed system for the multipliers.
/// `statics`: without inertia.
template <class Scalar>
void required_forces(const BasicModel<Scalar>& model, const BasicConstraints<Scalar>& constraints,
                     std::span<const std::type_identity_t<Scalar>> velocity,
                     std::span<const std::type_identity_t<Scalar>> acceleration, bool statics,
                     std::span<std::type_identity_t<Scalar>> required);

/// The contribution of springs to it. The model is in the unit of length of the constraints.
template <class Scalar>
void supply_springs(const BasicModel<Scalar>& model, const BasicConstraints<Scalar>& constraints,
                    std::span<const std::type_identity_t<Scalar>> velocity,
                    std::span<std::type_identity_t<Scalar>> required);

/// Reactions and efforts from the multipliers; `length`: the unit of length of the constraints, in m.
template <class Scalar>
void share_out(const BasicModel<Scalar>& model, const BasicConstraints<Scalar>& constraints,
               std::span<const std::type_identity_t<Scalar>> multipliers, double length,
               std::span<BasicReaction<std::type_identity_t<Scalar>>> reactions,
               std::span<std::type_identity_t<Scalar>> effort);

}  // namespace loadpath::mechanism
