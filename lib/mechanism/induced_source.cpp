#include "lib/mechanism/induced_source.hpp"

#include "lib/numerics/dual.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {
namespace {

using std::abs, std::copysign, std::sqrt, std::tan;

template <class Scalar>
double sign(const Scalar& value) {
  return value > 0.0 ? 1.0 : (value < 0.0 ? -1.0 : 0.0);
}

bool has_teeth(const Joint& joint) {
  return (joint.kind == JointKind::gear || joint.kind == JointKind::rack) && joint.pressure_angle != 0.0;
}

/// The span of a belt that is not the one of its equation: mirrored at the line of centres.
template <class Scalar>
struct Span {
  BasicVec<Scalar> at, along;
};
template <class Scalar>
Span<Scalar> other_span(const BasicPairShape<Scalar>& shape, const BasicPairPlace<Scalar>& at) {
  const BasicVec<Scalar> e = (-1.0 / sqrt(dot(at.apart, at.apart))) * at.apart;
  const BasicVec<Scalar> along = 2.0 * dot(e, at.along) * e - at.along;
  return {at.seat + at.apart - shape.radius_i * normal(along), along};
}

}  // namespace

bool rubs(const Joint& joint) { return joint.kind != JointKind::belt && !has_teeth(joint) && joint.friction.any(); }

std::size_t modes_of(const Joint& joint) {
  if (joint.kind == JointKind::belt || has_teeth(joint)) return 1;
  if (!rubs(joint)) return 0;
  switch (joint.kind) {
    case JointKind::prismatic:
    case JointKind::slot:
      return 2;
    case JointKind::revolute:
    case JointKind::rolling:
    case JointKind::rolling_on_line:
    case JointKind::cam:
      return 1;
    default:
      return 0;
  }
}

template <class Scalar>
void set_up(const BasicJoint<Scalar>& joint, std::span<const BasicPose<std::type_identity_t<Scalar>>> poses,
            std::span<const BasicPose<std::type_identity_t<Scalar>>> velocities, BasicInducedSource<Scalar>& source) {
  const auto placed = [&](int link) {
    if (link == ground) return BasicPlaced<Scalar>{};
    const BasicPose<Scalar>& pose = poses[static_cast<std::size_t>(link)];
    return BasicPlaced<Scalar>{turn(pose.phi), {pose.x, pose.y}, pose.phi};
  };
  const auto speed = [&](int link) {
    return link == ground ? BasicPose<Scalar>{} : velocities[static_cast<std::size_t>(link)];
  };
  const BasicPlaced<Scalar> i = placed(joint.i), j = placed(joint.j);
  const BasicPose<Scalar> speed_i = speed(joint.i), speed_j = speed(joint.j);
  place(source.shape, i, j, source.place);
  source.turning = speed_i.phi - speed_j.phi;
  const BasicVec<Scalar> pin = source.place.at;
  const BasicVec<Scalar> apart = BasicVec<Scalar>{speed_i.x, speed_i.y} + speed_i.phi * normal(pin - i.origin) -
                                 BasicVec<Scalar>{speed_j.x, speed_j.y} - speed_j.phi * normal(pin - j.origin);
  source.sliding = dot(source.place.along, apart);
}

template <class Scalar>
void set_modes(const BasicInducedSource<Scalar>& source,
               std::span<BasicInducedMode<std::type_identity_t<Scalar>>> modes) {
  const BasicPairPlace<Scalar>& at = source.place;
  BasicInducedMode<Scalar>* const mode = modes.data();
  mode->at = at.at;
  switch (source.shape.joint) {
    case JointKind::gear:  // towards the axis of wheel i
      mode->force = -at.along;
      break;
    case JointKind::rack:
      mode->force = copysign(Scalar(1.0), source.shape.radius_i) * normal(at.along);
      break;
    case JointKind::belt: {
      const Span<Scalar> other = other_span(source.shape, at);
      mode->force = at.along + other.along;
      mode->couple = cross(other.at - at.at, other.along);
      break;
    }
    case JointKind::prismatic:
    case JointKind::slot:
      mode->force = at.along;
      mode[1].at = at.at;
      mode[1].couple = 1.0;
      break;
    case JointKind::cam:
      mode->force = at.along;
      break;
    default:
      mode->couple = 1.0;
  }
}

template <class Scalar>
void induce(const BasicJoint<Scalar>& joint, const BasicInducedSource<Scalar>& source, const BasicReaction<Scalar>& by,
            double share, std::span<std::type_identity_t<Scalar>> amount) {
  const BasicFriction<Scalar>& friction = joint.friction;
  const Scalar mu = share * friction.coefficient;
  const BasicVec<Scalar> along = source.place.along;
  switch (joint.kind) {
    case JointKind::gear:
      amount[0] = tan(joint.pressure_angle) * abs(dot(by.force, normal(along)));
      break;
    case JointKind::rack:
      amount[0] = tan(joint.pressure_angle) * abs(dot(by.force, along));
      break;
    case JointKind::belt:  // the equation's span cannot push: then the other one pulls
      amount[0] = joint.tension + std::max<Scalar>(0.0, -dot(by.force, along));
      break;
    case JointKind::revolute:
      amount[0] = -sign(source.turning) * mu * friction.pin_radius * length(by.force) -
                  share * friction.viscous * source.turning;
      break;
    case JointKind::prismatic: {
      const Scalar pressing = dot(by.force, normal(along));
      const Scalar tilting = joint.guide_length > 0.0 ? 2.0 * by.couple / joint.guide_length : Scalar(0.0);
      const Scalar edges = std::max<Scalar>(abs(pressing), abs(tilting));  // |R/2 + R h/l| + |R/2 - R h/l|
      amount[0] = -sign(source.sliding) * mu * edges - share * friction.viscous * source.sliding;
      amount[1] = -sign(source.sliding) * mu * 0.5 * joint.guide_width * pressing;
      break;
    }
    case JointKind::slot: {  // where the pin touches it may slide, roll or both
      const Scalar pressing = dot(by.force, normal(along));
      const Scalar arm = sign(pressing) * friction.pin_radius;
      const Scalar rubbing = source.sliding + arm * source.turning;
      amount[0] = -sign(rubbing) * mu * abs(pressing) - share * friction.viscous * rubbing;
      amount[1] = arm * amount[0];
      break;
    }
    case JointKind::cam:
      amount[0] = -sign(source.sliding) * mu * abs(dot(by.force, source.place.rows[0].e)) -
                  share * friction.viscous * source.sliding;
      break;
    default:
      amount[0] = -sign(source.turning) * share * friction.rolling_arm * abs(dot(by.force, source.place.rows[1].e)) -
                  share * friction.viscous * source.turning;
  }
}

template <class Scalar>
void take_from_required(const BasicInducedMode<Scalar>& mode, std::type_identity_t<Scalar> amount, double length,
                        const BasicPair<Scalar>& pair, std::span<const std::type_identity_t<Scalar>> q,
                        std::span<std::type_identity_t<Scalar>> required) {
  const Scalar force = amount / length;
  const auto act = [&](std::size_t link, const Scalar& on_link) {
    if (3 * link >= required.size()) return;  // the ground
    const BasicVec<Scalar> arm = (1.0 / length) * mode.at - BasicVec<Scalar>{q[3 * link], q[3 * link + 1]};
    required[3 * link] += on_link * mode.force.x;
    required[3 * link + 1] += on_link * mode.force.y;
    required[3 * link + 2] += on_link * (mode.couple / length + cross(arm, mode.force));
  };
  act(pair.i, -force);
  act(pair.j, force);
}

template void set_up(const BasicJoint<double>&, std::span<const BasicPose<double>>, std::span<const BasicPose<double>>,
                     BasicInducedSource<double>&);
template void set_modes(const BasicInducedSource<double>&, std::span<BasicInducedMode<double>>);
template void induce(const BasicJoint<double>&, const BasicInducedSource<double>&, const BasicReaction<double>&, double,
                     std::span<double>);
template void set_up(const BasicJoint<Dual>&, std::span<const BasicPose<Dual>>, std::span<const BasicPose<Dual>>,
                     BasicInducedSource<Dual>&);
template void set_modes(const BasicInducedSource<Dual>&, std::span<BasicInducedMode<Dual>>);
template void induce(const BasicJoint<Dual>&, const BasicInducedSource<Dual>&, const BasicReaction<Dual>&, double,
                     std::span<Dual>);
template void take_from_required(const BasicInducedMode<double>&, double, double, const BasicPair<double>&,
                                 std::span<const double>, std::span<double>);
template void take_from_required(const BasicInducedMode<Dual>&, Dual, double, const BasicPair<Dual>&,
                                 std::span<const Dual>, std::span<Dual>);

}  // namespace loadpath::mechanism
