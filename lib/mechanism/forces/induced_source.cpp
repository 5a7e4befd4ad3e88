#include "lib/mechanism/forces/induced_source.hpp"

#include "lib/mechanism/forces/mixed_friction.hpp"
#include "lib/mechanism/model/frames.hpp"
#include "lib/mechanism/model/point_motion.hpp"
#include "lib/numerics/dual.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {

using numerics::Dual;

namespace {

using std::abs, std::copysign, std::sqrt, std::tan;

template <class Scalar>
double sign(const Scalar& value) {
  return value > 0.0 ? 1.0 : (value < 0.0 ? -1.0 : 0.0);
}

/// Teeth press the wheels apart, the slack span of a belt draws them together.
template <class Scalar>
bool has_steady_mode(const BasicJoint<Scalar>& joint) {
  return joint.kind == JointKind::belt || !(joint.pressure_angle == 0.0);
}

template <class Scalar>
bool loses(const BasicJoint<Scalar>& joint) {
  return !(joint.friction.loss == 0.0 && joint.friction.loss_back == 0.0);
}

bool passes_power(JointKind kind) {
  return kind == JointKind::gear || kind == JointKind::rack || kind == JointKind::belt;
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

/// The force through teeth or a belt, and its lever arms about the wheels; for a rack only about its wheel.
template <class Scalar>
struct Passing {
  BasicVec<Scalar> along;
  Scalar arm_i = 0.0, arm_j = 0.0;
};
template <class Scalar>
Passing<Scalar> passing(const BasicPairShape<Scalar>& shape, const BasicPairPlace<Scalar>& at) {
  const BasicVec<Scalar> along = shape.joint == JointKind::gear ? normal(at.along) : at.along;
  return {along, cross(at.at - at.seat - at.apart, along), cross(at.at - at.seat, along)};
}

/// The modes of losses: the first if wheel i drives, which then transmits all the power, and link j receives less;
/// the second if link j drives. Two wheels: a force across the line of centres, in the centre of the driving one. A
/// rack: a force along it in the wheel's centre, or a couple on the wheel.
template <class Scalar>
void set_loss_modes(const BasicPairShape<Scalar>& shape, const BasicPairPlace<Scalar>& at,
                    std::span<BasicInducedMode<std::type_identity_t<Scalar>>, 2> modes) {
  const BasicVec<Scalar> centre_i = at.seat + at.apart;
  const auto in = [&](BasicInducedMode<Scalar>& mode, BasicVec<Scalar> place, BasicVec<Scalar> force) {
    mode.at = at.at;
    mode.force = force;
    mode.couple = cross(place - at.at, force);
  };
  if (shape.joint == JointKind::rack) {
    in(modes[0], centre_i, at.along);
    in(modes[1], at.at, {});
    modes[1].couple = 1.0;
    return;
  }
  const BasicVec<Scalar> across = normal((1.0 / sqrt(dot(at.apart, at.apart))) * at.apart);
  in(modes[0], centre_i, across);
  in(modes[1], at.seat, across);
}

/// Their amounts: the power of a mode is that share of the transmitted power. No loss at rest.
template <class Scalar>
void induce_loss(const BasicJoint<Scalar>& joint, const BasicInducedSource<Scalar>& source,
                 const BasicReaction<Scalar>& by, double share, std::span<std::type_identity_t<Scalar>, 2> amount) {
  const Passing<Scalar> through = passing(source.shape, source.place);
  const Scalar force = dot(by.force, through.along);
  const double sense = sign(source.tendency.passing);
  const bool i_drives = sign(force) * sense < 0.0;
  const Scalar lost = share * (i_drives ? joint.friction.loss : joint.friction.loss_back) * abs(force) * sense;
  amount[0] = amount[1] = 0.0;
  if (joint.kind == JointKind::rack) {
    amount[i_drives ? 0 : 1] = i_drives ? lost : -lost * through.arm_i;
    return;
  }
  const Scalar apart = sqrt(dot(source.place.apart, source.place.apart));
  amount[i_drives ? 0 : 1] = lost * (i_drives ? through.arm_j : through.arm_i) / apart;
}

/// The separating force of teeth, or the tension of the other span of a belt.
template <class Scalar>
Scalar steady_amount(const BasicJoint<Scalar>& joint, BasicVec<Scalar> along, BasicVec<Scalar> force) {
  if (joint.kind == JointKind::gear) return tan(joint.pressure_angle) * abs(dot(force, normal(along)));
  if (joint.kind == JointKind::rack) return tan(joint.pressure_angle) * abs(dot(force, along));
  // The span of the equation cannot transmit compression: then the other one is in tension.
  return joint.tension + std::max<Scalar>(0.0, -dot(force, along));
}

/// Along the slide, and the couple of its two edges.
template <class Scalar>
void induce_in_slide(const BasicJoint<Scalar>& joint, const BasicInducedSource<Scalar>& source,
                     const BasicReaction<Scalar>& by, double share, std::span<std::type_identity_t<Scalar>> amount) {
  const Scalar mu = share * coefficient_at(joint.friction, source.sliding);
  const double sliding = sign(source.tendency.sliding);
  const Scalar pressing = dot(by.force, normal(source.place.along));
  const Scalar tilting = joint.guide_length > 0.0 ? 2.0 * by.couple / joint.guide_length : Scalar(0.0);
  const Scalar edges = std::max<Scalar>(abs(pressing), abs(tilting));  // |R/2 + R h/l| + |R/2 - R h/l|
  amount[0] = -sliding * mu * edges - share * joint.friction.viscous * source.sliding;
  amount[1] = -sliding * mu * 0.5 * joint.guide_width * pressing;
}

/// The contact of the pin may slide, roll or both.
template <class Scalar>
void induce_in_slot(const BasicJoint<Scalar>& joint, const BasicInducedSource<Scalar>& source,
                    const BasicReaction<Scalar>& by, double share, std::span<std::type_identity_t<Scalar>> amount) {
  const Scalar pressing = dot(by.force, normal(source.place.along));
  const Scalar arm = sign(pressing) * joint.friction.pin_radius;
  const double sense = sign(source.tendency.sliding + numerics::value_of(arm) * source.tendency.turning);
  const Scalar speed = source.sliding + arm * source.turning;
  amount[0] =
      -sense * share * coefficient_at(joint.friction, speed) * abs(pressing) - share * joint.friction.viscous * speed;
  amount[1] = arm * amount[0];
}

/// The motion of a joint, or its rate, from that of points and angles of links.
template <class PointRate, class TurnRate>
JointMotion measured(const Joint& joint, const InducedSource& source, PointRate of_point, TurnRate of_angle) {
  const PairPlace& at = source.place;
  JointMotion motion;
  motion.sliding = dot(at.along, of_point(joint.i, at.at) - of_point(joint.j, at.at));
  motion.turning = of_angle(joint.i) - of_angle(joint.j);
  if (!passes_power(joint.kind)) return motion;
  double against_centres = motion.turning;
  if (joint.kind != JointKind::rack) {
    const Vec apart = of_point(joint.i, at.seat + at.apart) - of_point(joint.j, at.seat);
    against_centres = of_angle(joint.i) - cross(at.apart, apart) / dot(at.apart, at.apart);
  }
  motion.passing = against_centres * passing(source.shape, at).arm_i;
  return motion;
}

JointMotion velocity_of(const Joint& joint, const InducedSource& source, const Position& at) {
  const auto rates = [&](int link) { return link == ground ? Pose{} : at.tendency[static_cast<std::size_t>(link)]; };
  const auto of_point = [&](int link, Vec point) {
    return point_velocity(rates(link), point - placed_at(at, link).origin);
  };
  return measured(joint, source, of_point, [&](int link) { return rates(link).phi; });
}

JointMotion acceleration_of(const Joint& joint, const InducedSource& source, const Position& at) {
  const auto rates = [&](int link) {
    return link == ground ? Pose{} : at.acceleration[static_cast<std::size_t>(link)];
  };
  const auto of_point = [&](int link, Vec point) {
    return point_acceleration(rates(link), speeds_at(at, link).omega, point - placed_at(at, link).origin);
  };
  return measured(joint, source, of_point, [&](int link) { return rates(link).phi; });
}

}  // namespace

bool rubs(const Joint& joint) { return joint.friction.any(); }

std::size_t modes_of(const Joint& joint) {
  switch (joint.kind) {
    case JointKind::gear:
    case JointKind::rack:
    case JointKind::belt:
      return (has_steady_mode(joint) ? 1 : 0) + (loses(joint) ? 2 : 0);
    case JointKind::prismatic:
    case JointKind::slot:
      return rubs(joint) ? 2 : 0;
    case JointKind::revolute:
    case JointKind::rolling:
    case JointKind::rolling_on_line:
    case JointKind::cam:
      return rubs(joint) ? 1 : 0;
    case JointKind::rigid:
    case JointKind::none:
      break;
  }
  return 0;
}

template <class Scalar>
void set_up(const BasicJoint<Scalar>& joint, std::span<const BasicPose<std::type_identity_t<Scalar>>> poses,
            std::span<const BasicPose<std::type_identity_t<Scalar>>> velocities, BasicInducedSource<Scalar>& source) {
  const BasicPlaced<Scalar> i = placed_by<Scalar>(poses, joint.i), j = placed_by<Scalar>(poses, joint.j);
  const BasicSpeeds<Scalar> speed_i = speeds_by<Scalar>(velocities, joint.i),
                            speed_j = speeds_by<Scalar>(velocities, joint.j);
  place(source.shape, i, j, source.place);
  source.turning = speed_i.omega - speed_j.omega;
  const BasicVec<Scalar> pin = source.place.at;
  source.sliding = dot(source.place.along, velocity_at(pin, i, speed_i) - velocity_at(pin, j, speed_j));
}

JointMotion tendency_of(const Joint& joint, const InducedSource& source, const Position& at, Resting resting,
                        const RestLimits& limits) {
  JointMotion motion = velocity_of(joint, source, at);
  const bool slides = abs(motion.sliding) > limits.speed, turns = abs(motion.turning) > limits.omega;
  const bool passes = abs(motion.passing) > limits.speed;
  JointMotion next;
  if (resting != Resting::without_friction && !(slides && turns && passes)) {
    next = acceleration_of(joint, source, at);
    const double way = resting == Resting::as_before ? -1.0 : 1.0;
    next.sliding = abs(next.sliding) > limits.acceleration ? way * next.sliding : 0.0;
    next.turning = abs(next.turning) > limits.epsilon ? way * next.turning : 0.0;
    next.passing = abs(next.passing) > limits.acceleration ? way * next.passing : 0.0;
  }
  if (!slides) motion.sliding = next.sliding;
  if (!turns) motion.turning = next.turning;
  if (!passes) motion.passing = next.passing;
  return motion;
}

bool rests(const Joint& joint, const InducedSource& source) {
  const bool slides = source.tendency.sliding != 0.0, turns = source.tendency.turning != 0.0;
  switch (joint.kind) {
    case JointKind::gear:
    case JointKind::rack:
    case JointKind::belt:
      return source.tendency.passing == 0.0;
    case JointKind::prismatic:
    case JointKind::cam:
      return !slides;
    case JointKind::slot:  // turning, a pin rubs only at its radius
      return !slides && (joint.friction.pin_radius == 0.0 || !turns);
    case JointKind::revolute:
    case JointKind::rolling:
    case JointKind::rolling_on_line:
      return !turns;
    case JointKind::rigid:
    case JointKind::none:
      break;
  }
  return false;
}

template <class Scalar>
void set_modes(const BasicJoint<Scalar>& joint, const BasicInducedSource<Scalar>& source,
               std::span<BasicInducedMode<std::type_identity_t<Scalar>>> modes) {
  const BasicPairPlace<Scalar>& at = source.place;
  BasicInducedMode<Scalar>* const mode = modes.data();
  if (passes_power(joint.kind) && loses(joint))
    set_loss_modes(source.shape, at, modes.subspan(has_steady_mode(joint) ? 1 : 0).template first<2>());
  if (passes_power(joint.kind) && !has_steady_mode(joint)) return;
  mode->at = at.at;
  switch (joint.kind) {
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
    case JointKind::revolute:
    case JointKind::rolling:
    case JointKind::rolling_on_line:
      mode->couple = 1.0;
      break;
    case JointKind::rigid:
    case JointKind::none:
      break;
  }
}

template <class Scalar>
void induce(const BasicJoint<Scalar>& joint, const BasicInducedSource<Scalar>& source, const BasicReaction<Scalar>& by,
            double share, std::span<std::type_identity_t<Scalar>> amount) {
  const BasicFriction<Scalar>& friction = joint.friction;
  const Scalar viscous = share * friction.viscous;
  const double sliding = sign(source.tendency.sliding), turning = sign(source.tendency.turning);
  switch (joint.kind) {
    case JointKind::gear:
    case JointKind::rack:
    case JointKind::belt: {
      const std::size_t steady = has_steady_mode(joint) ? 1 : 0;
      if (steady == 1) amount[0] = steady_amount(joint, source.place.along, by.force);
      if (loses(joint)) induce_loss(joint, source, by, share, amount.subspan(steady).template first<2>());
      break;
    }
    case JointKind::revolute:
      amount[0] = -turning * share * coefficient_at(friction, friction.pin_radius * source.turning) *
                      friction.pin_radius * length(by.force) -
                  viscous * source.turning;
      break;
    case JointKind::prismatic:
      induce_in_slide(joint, source, by, share, amount);
      break;
    case JointKind::slot:
      induce_in_slot(joint, source, by, share, amount);
      break;
    case JointKind::cam:
      amount[0] =
          -sliding * share * coefficient_at(friction, source.sliding) * abs(dot(by.force, source.place.rows[0].e)) -
          viscous * source.sliding;
      break;
    case JointKind::rolling:
    case JointKind::rolling_on_line:
      amount[0] = -turning * share * friction.rolling_arm * abs(dot(by.force, source.place.rows[1].e)) -
                  viscous * source.turning;
      break;
    case JointKind::rigid:
    case JointKind::none:
      break;
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
template void set_modes(const BasicJoint<double>&, const BasicInducedSource<double>&,
                        std::span<BasicInducedMode<double>>);
template void induce(const BasicJoint<double>&, const BasicInducedSource<double>&, const BasicReaction<double>&, double,
                     std::span<double>);
template void set_up(const BasicJoint<Dual>&, std::span<const BasicPose<Dual>>, std::span<const BasicPose<Dual>>,
                     BasicInducedSource<Dual>&);
template void set_modes(const BasicJoint<Dual>&, const BasicInducedSource<Dual>&, std::span<BasicInducedMode<Dual>>);
template void induce(const BasicJoint<Dual>&, const BasicInducedSource<Dual>&, const BasicReaction<Dual>&, double,
                     std::span<Dual>);
template void take_from_required(const BasicInducedMode<double>&, double, double, const BasicPair<double>&,
                                 std::span<const double>, std::span<double>);
template void take_from_required(const BasicInducedMode<Dual>&, Dual, double, const BasicPair<Dual>&,
                                 std::span<const Dual>, std::span<Dual>);

}  // namespace loadpath::mechanism
