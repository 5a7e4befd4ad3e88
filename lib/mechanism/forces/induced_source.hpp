// Forces induced by a joint's reaction: the separating force of gear teeth, the slack side of a belt, friction. Their
// points of action, and their ratios to the reaction.
#pragma once

#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/pair.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <span>
#include <type_traits>

namespace loadpath::mechanism {

/// An induced force of the amount 1: on link i of its joint, at `at`, the opposite on link j. The amounts are in N, or
/// in N m where it is a couple.
template <class Scalar>
struct BasicInducedMode {
  std::size_t joint = 0;
  BasicVec<Scalar> at;
  BasicVec<Scalar> force;
  Scalar couple = 0.0;
};
using InducedMode = BasicInducedMode<double>;

/// The motion of a joint that determines the direction of its friction; 0 at rest.
struct JointMotion {
  double sliding = 0.0;  // sliding velocity, m/s, of link i along the line of j
  double turning = 0.0;  // angular velocity, rad/s, of link i against link j
  double passing = 0.0;  // teeth, belts: m/s, of link i's wheel along the force on it, seen from the line of centres
};

/// A joint that induces forces, at a position.
template <class Scalar>
struct BasicInducedSource {
  std::size_t joint = 0;
  std::size_t first = 0;  // index of its first mode
  BasicPairShape<Scalar> shape = {};
  BasicPairPlace<Scalar> place = {};
  Scalar sliding = 0.0;  // as of JointMotion
  Scalar turning = 0.0;
  JointMotion tendency = {};
};
using InducedSource = BasicInducedSource<double>;

/// The direction of friction in a joint that rests while the mechanism moves, as at a dead point: none, or that of
/// its motion just before or just after.
enum class Resting { without_friction, as_before, as_after };
struct FrictionTaken {
  Resting resting = Resting::without_friction;
  double share = 1.0;  // factor on the model's coefficients and losses
};

/// The number of forces that the reaction of this joint induces.
std::size_t modes_of(const Joint& joint);
/// Whether there is friction among them.
bool rubs(const Joint& joint);

/// Goes to a position; the tendency is left.
template <class Scalar>
void set_up(const BasicJoint<Scalar>& joint, std::span<const BasicPose<std::type_identity_t<Scalar>>> poses,
            std::span<const BasicPose<std::type_identity_t<Scalar>>> velocities, BasicInducedSource<Scalar>& source);
/// Slower than this is rest: rounding errors of zero motion.
struct RestLimits {
  double speed = 0.0, omega = 0.0;           // m/s, rad/s
  double acceleration = 0.0, epsilon = 0.0;  // m/s^2, rad/s^2
};
/// The tendency of motion of a joint at the source, from that of the position.
JointMotion tendency_of(const Joint& joint, const InducedSource& source, const Position& at, Resting resting,
                        const RestLimits& limits);
/// Whether its dry friction has no sense.
bool rests(const Joint& joint, const InducedSource& source);
template <class Scalar>
void set_modes(const BasicJoint<Scalar>& joint, const BasicInducedSource<Scalar>& source,
               std::span<BasicInducedMode<std::type_identity_t<Scalar>>> modes);
/// The amounts that a force of the joint's constraints induces; `share`: of the coefficients of friction.
template <class Scalar>
void induce(const BasicJoint<Scalar>& joint, const BasicInducedSource<Scalar>& source, const BasicReaction<Scalar>& by,
            double share, std::span<std::type_identity_t<Scalar>> amount);
/// Subtracts the effect of this amount of a mode on the links i and j from the forces that the constraints must
/// supply; `length`: the unit of length of the coordinates q and of the forces, m.
template <class Scalar>
void take_from_required(const BasicInducedMode<Scalar>& mode, std::type_identity_t<Scalar> amount, double length,
                        const BasicPair<Scalar>& pair, std::span<const std::type_identity_t<Scalar>> q,
                        std::span<std::type_identity_t<Scalar>> required);

}  // namespace loadpath::mechanism
