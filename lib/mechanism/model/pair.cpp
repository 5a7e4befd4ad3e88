#include "lib/mechanism/model/pair.hpp"

#include "lib/mechanism/model/cam.hpp"
#include "lib/mechanism/model/whole_turn.hpp"
#include "lib/numerics/dual.hpp"

#include <cmath>

namespace loadpath::mechanism {

using numerics::Dual;

namespace {

using std::atan2, std::copysign, std::round, std::sqrt;

template <class Scalar>
bool is_joint(const BasicPairShape<Scalar>& shape, JointKind kind) {
  return shape.kind == PairKind::joint && shape.joint == kind;
}

template <class Scalar>
bool holds_pin(const BasicPairShape<Scalar>& shape) {
  return is_joint(shape, JointKind::revolute) || is_joint(shape, JointKind::rigid);
}

template <class Scalar>
bool on_line(const BasicPairShape<Scalar>& shape) {
  return is_joint(shape, JointKind::prismatic) || is_joint(shape, JointKind::slot);
}

template <class Scalar>
bool has_wheel_on_line(const BasicPairShape<Scalar>& shape) {
  return is_joint(shape, JointKind::rack) || is_joint(shape, JointKind::rolling_on_line);
}

template <class Scalar>
bool has_two_wheels(const BasicPairShape<Scalar>& shape) {
  return is_joint(shape, JointKind::gear) || is_joint(shape, JointKind::rolling) || is_joint(shape, JointKind::belt);
}

/// The radius of wheel j in an equivalent gear with the speed ratio of the belt.
template <class Scalar>
Scalar rolling_radius_j(const BasicPairShape<Scalar>& shape) {
  return is_joint(shape, JointKind::belt) ? -shape.radius_j : shape.radius_j;
}

/// The constant of rolling wheels, apart from full revolutions of the line of centres.
template <class Scalar>
Scalar rolled(const BasicPairShape<Scalar>& shape, const BasicPairPlace<Scalar>& at, const BasicPlaced<Scalar>& i,
              const BasicPlaced<Scalar>& j) {
  if (has_wheel_on_line(shape)) return dot(at.along, at.apart) + shape.radius_i * (i.phi - j.phi);
  const Scalar radius_j = rolling_radius_j(shape);
  return shape.radius_i * i.phi + radius_j * j.phi - (shape.radius_i + radius_j) * at.centres;
}

template <class Scalar>
void turn_centres(BasicPairPlace<Scalar>& at) {
  const Scalar angle = atan2(-at.apart.y, -at.apart.x);
  at.centres = angle + whole_turn * round((at.centres - angle) / whole_turn);
}

/// The tangent of the belt from wheel i to wheel j: the span that wheel i pays out when it rotates clockwise.
template <class Scalar>
void place_belt(const BasicPairShape<Scalar>& shape, BasicPairPlace<Scalar>& at) {
  const Scalar distance = sqrt(dot(at.apart, at.apart));
  const BasicVec<Scalar> e = (-1.0 / distance) * at.apart;
  const Scalar sine = (shape.radius_i - shape.radius_j) / distance;
  const Scalar cosine = sqrt(1.0 - sine * sine);
  at.along = cosine * e - sine * normal(e);
  at.rows[0].e = at.along;
  at.at = at.at + shape.radius_i * normal(at.along);
}

template <class Scalar>
void place_wheels(const BasicPairShape<Scalar>& shape, BasicPairPlace<Scalar>& at) {
  turn_centres(at);
  if (is_joint(shape, JointKind::belt)) return place_belt(shape, at);
  const Scalar sum = shape.radius_i + shape.radius_j;
  const Scalar towards = (sum < 0.0 ? 1.0 : -1.0) / sqrt(dot(at.apart, at.apart));
  at.along = towards * at.apart;
  at.rows[0].e = normal(at.along);
  at.rows[1].e = at.along;
  // Pitch circles that lie a little apart touch where they divide the line of centres.
  at.at = at.at - (shape.radius_i / sum) * at.apart;
}

template <class Scalar>
void place_on_line(const BasicPairShape<Scalar>& shape, BasicPairPlace<Scalar>& at) {
  at.rows[0].e = at.along;
  at.rows[1].e = normal(at.along);
  at.at = at.at - shape.radius_i * normal(at.along);
}

}  // namespace

template <class Scalar>
BasicPairShape<Scalar> shape_of(const BasicJoint<Scalar>& joint) {
  return {.joint = joint.kind,
          .point_i = joint.point_i,
          .point_j = joint.point_j,
          .line = turn(joint.direction)({1.0, 0.0}),
          .angle = joint.angle,
          .turned = turn(joint.angle),
          .radius_i = joint.radius_i,
          .radius_j = joint.radius_j,
          .phase = joint.phase,
          .contact = joint.contact,
          .profile = joint.profile.get(),
          .metre = joint.metre};
}

template <class Scalar>
BasicPairShape<Scalar> shape_of(const BasicDriver<Scalar>& driver, const BasicJoint<Scalar>* joint) {
  BasicPairShape<Scalar> shape = joint == nullptr ? BasicPairShape<Scalar>{} : shape_of(*joint);
  shape.kind = driver.kind == Driver::Kind::rotary ? PairKind::turning_drive : PairKind::sliding_drive;
  shape.offset = driver.offset;
  return shape;
}

template <class Scalar>
RowPattern pattern_of(const BasicPairShape<Scalar>& shape, std::size_t row) {
  if (holds_pin(shape) && row < 2) return {row == 0, row == 1, true};
  const bool turning = shape.kind == PairKind::turning_drive || is_joint(shape, JointKind::rigid) ||
                       (is_joint(shape, JointKind::prismatic) && row == 1);
  return {!turning, !turning, true};
}

template <class Scalar>
void prepare(const BasicPairShape<Scalar>& shape, BasicPairPlace<Scalar>& at) {
  if (holds_pin(shape))
    at.rows = {BasicPairRow<Scalar>{{1.0, 0.0}}, BasicPairRow<Scalar>{{0.0, 1.0}}, BasicPairRow<Scalar>{{}, 1.0}};
  if (shape.kind == PairKind::turning_drive) at.rows[0].m = 1.0;
  if (is_joint(shape, JointKind::prismatic)) at.rows[1].m = 1.0;
}

template <class Scalar>
void place(const BasicPairShape<Scalar>& shape, const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
           BasicPairPlace<Scalar>& at) {
  at.at = i.point(shape.point_i);
  at.at_j = at.seat = j.point(shape.point_j);
  at.apart = at.at - at.seat;
  if (holds_pin(shape) || shape.kind == PairKind::turning_drive) return;
  at.along = j.turned(shape.line);
  if (is_joint(shape, JointKind::cam)) {
    place_cam(shape, i, j, at);
  } else if (has_two_wheels(shape)) {
    place_wheels(shape, at);
  } else if (has_wheel_on_line(shape)) {
    place_on_line(shape, at);
  } else {
    at.rows[0].e = shape.kind == PairKind::sliding_drive ? at.along : normal(at.along);
  }
  at.at_j = at.at;
}

template <class Scalar>
void count_turns(const BasicPairShape<Scalar>& shape, const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j,
                 BasicPairPlace<Scalar>& at) {
  if (!has_two_wheels(shape)) return;
  const Scalar turn = whole_turn * (shape.radius_i + rolling_radius_j(shape));
  if (turn != 0.0) at.centres += whole_turn * round((rolled(shape, at, i, j) - shape.phase) / turn);
}

template <class Scalar>
bool has_phase(const BasicPairShape<Scalar>& shape) {
  return has_two_wheels(shape) || has_wheel_on_line(shape);
}

template <class Scalar>
void take_phases(BasicModel<Scalar>& model) {
  const auto placed = [&](int link) {
    if (link == ground) return BasicPlaced<Scalar>{};
    const BasicPose<Scalar>& pose = model.links[static_cast<std::size_t>(link)].pose;
    return BasicPlaced<Scalar>{turn(pose.phi), {pose.x, pose.y}, pose.phi};
  };
  for (BasicJoint<Scalar>& joint : model.joints) {
    const BasicPairShape<Scalar> shape = shape_of(joint);
    if (!has_phase(shape)) continue;
    BasicPairPlace<Scalar> at;
    place(shape, placed(joint.i), placed(joint.j), at);
    joint.phase = rolled(shape, at, placed(joint.i), placed(joint.j));
  }
}

template <class Scalar>
void open(const BasicPairShape<Scalar>& shape, const BasicPairPlace<Scalar>& at, const BasicPlaced<Scalar>& i,
          const BasicPlaced<Scalar>& j, std::type_identity_t<Scalar> target,
          std::span<std::type_identity_t<Scalar>> residual) {
  if (is_joint(shape, JointKind::none)) return;
  const Scalar turned = i.phi - j.phi;
  if (shape.kind == PairKind::turning_drive) {
    residual[0] = turned + shape.offset - target;
  } else if (shape.kind == PairKind::sliding_drive) {
    residual[0] = dot(at.along, at.apart) + shape.offset - target;
  } else if (holds_pin(shape)) {
    residual[0] = at.apart.x;
    residual[1] = at.apart.y;
    if (residual.size() == 3) residual[2] = turned - shape.angle;
  } else if (on_line(shape)) {
    residual[0] = dot(normal(at.along), at.apart);
    if (residual.size() == 2) residual[1] = turned - shape.angle;
  } else if (is_joint(shape, JointKind::cam)) {
    residual[0] = at.touch.gap;
  } else {
    residual[0] = rolled(shape, at, i, j) - shape.phase;
    if (is_joint(shape, JointKind::belt)) residual[0] = -residual[0];
    if (is_joint(shape, JointKind::rolling_on_line)) residual[1] = dot(normal(at.along), at.apart) - shape.radius_i;
    if (is_joint(shape, JointKind::rolling)) {
      const Scalar sum = shape.radius_i + shape.radius_j;
      residual[1] = sum - copysign(sqrt(dot(at.apart, at.apart)), sum);
    }
  }
}

template <class Scalar>
void held_acceleration(const BasicPairShape<Scalar>& shape, const BasicPairPlace<Scalar>& at,
                       const BasicPlaced<Scalar>& i, const BasicPlaced<Scalar>& j, const BasicSpeeds<Scalar>& speed_i,
                       const BasicSpeeds<Scalar>& speed_j, std::span<std::type_identity_t<Scalar>> along) {
  for (Scalar& a : along) a = 0.0;
  if (on_line(shape)) {  // Coriolis
    const BasicVec<Scalar> sliding = velocity_at(at.at, i, speed_i) - velocity_at(at.at, j, speed_j);
    along[0] = 2.0 * speed_j.omega * dot(at.along, sliding);
  } else if (is_joint(shape, JointKind::cam)) {
    along[0] = acceleration_on_cam(shape, at, i, j, speed_i, speed_j);
  } else if (is_joint(shape, JointKind::belt)) {
    // The row is taken at one end of the span: as the span turns, and link j under it, the other end falls behind.
    const BasicVec<Scalar> centre_i = at.seat + at.apart;
    const BasicVec<Scalar> apart = velocity_at(centre_i, i, speed_i) - velocity_at(at.seat, j, speed_j);
    const Scalar centres = cross(at.apart, apart) / dot(at.apart, at.apart);
    along[0] = dot(at.along, at.seat - at.at) * (centres * centres - speed_j.omega * speed_j.omega);
  } else if (is_joint(shape, JointKind::rolling_on_line)) {
    const Scalar omega = speed_i.omega - speed_j.omega;
    along[1] = shape.radius_i * omega * omega;
  } else if (is_joint(shape, JointKind::rolling)) {
    const Scalar sum = shape.radius_i + shape.radius_j;
    const Scalar centres = (shape.radius_i * speed_i.omega + shape.radius_j * speed_j.omega) / sum;
    along[1] = sum * centres * centres - shape.radius_i * speed_i.omega * speed_i.omega -
               shape.radius_j * speed_j.omega * speed_j.omega;
  }
}

template BasicPairShape<double> shape_of(const BasicJoint<double>&);
template BasicPairShape<double> shape_of(const BasicDriver<double>&, const BasicJoint<double>*);
template RowPattern pattern_of(const BasicPairShape<double>&, std::size_t);
template void prepare(const BasicPairShape<double>&, BasicPairPlace<double>&);
template void place(const BasicPairShape<double>&, const BasicPlaced<double>&, const BasicPlaced<double>&,
                    BasicPairPlace<double>&);
template void count_turns(const BasicPairShape<double>&, const BasicPlaced<double>&, const BasicPlaced<double>&,
                          BasicPairPlace<double>&);
template bool has_phase(const BasicPairShape<double>&);
template void take_phases(BasicModel<double>&);
template void open(const BasicPairShape<double>&, const BasicPairPlace<double>&, const BasicPlaced<double>&,
                   const BasicPlaced<double>&, double, std::span<double>);
template void held_acceleration(const BasicPairShape<double>&, const BasicPairPlace<double>&,
                                const BasicPlaced<double>&, const BasicPlaced<double>&, const BasicSpeeds<double>&,
                                const BasicSpeeds<double>&, std::span<double>);

template BasicPairShape<Dual> shape_of(const BasicJoint<Dual>&);
template BasicPairShape<Dual> shape_of(const BasicDriver<Dual>&, const BasicJoint<Dual>*);
template RowPattern pattern_of(const BasicPairShape<Dual>&, std::size_t);
template void prepare(const BasicPairShape<Dual>&, BasicPairPlace<Dual>&);
template void place(const BasicPairShape<Dual>&, const BasicPlaced<Dual>&, const BasicPlaced<Dual>&,
                    BasicPairPlace<Dual>&);
template void count_turns(const BasicPairShape<Dual>&, const BasicPlaced<Dual>&, const BasicPlaced<Dual>&,
                          BasicPairPlace<Dual>&);
template bool has_phase(const BasicPairShape<Dual>&);
template void take_phases(BasicModel<Dual>&);
template void open(const BasicPairShape<Dual>&, const BasicPairPlace<Dual>&, const BasicPlaced<Dual>&,
                   const BasicPlaced<Dual>&, Dual, std::span<Dual>);
template void held_acceleration(const BasicPairShape<Dual>&, const BasicPairPlace<Dual>&, const BasicPlaced<Dual>&,
                                const BasicPlaced<Dual>&, const BasicSpeeds<Dual>&, const BasicSpeeds<Dual>&,
                                std::span<Dual>);

}  // namespace loadpath::mechanism
