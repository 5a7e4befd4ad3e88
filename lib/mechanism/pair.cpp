#include "lib/mechanism/pair.hpp"

#include <cmath>
#include <numbers>

namespace loadpath::mechanism {
namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;

bool is_joint(const PairShape& shape, JointKind kind) {
  return shape.kind == PairShape::Kind::joint && shape.joint == kind;
}

bool holds_pin(const PairShape& shape) {
  return is_joint(shape, JointKind::revolute) || is_joint(shape, JointKind::rigid);
}

bool on_line(const PairShape& shape) {
  return is_joint(shape, JointKind::prismatic) || is_joint(shape, JointKind::slot);
}

bool has_wheel_on_line(const PairShape& shape) {
  return is_joint(shape, JointKind::rack) || is_joint(shape, JointKind::rolling_on_line);
}

bool has_two_wheels(const PairShape& shape) {
  return is_joint(shape, JointKind::gear) || is_joint(shape, JointKind::rolling) || is_joint(shape, JointKind::belt);
}

/// The radius of wheel j as a gear would have it that turns as the belt does.
double rolling_radius_j(const PairShape& shape) {
  return is_joint(shape, JointKind::belt) ? -shape.radius_j : shape.radius_j;
}

/// What the wheels keep constant while they roll, but for whole turns of the line of centres.
double rolled(const PairShape& shape, const PairPlace& at, const Placed& i, const Placed& j) {
  if (has_wheel_on_line(shape)) return dot(at.along, at.apart) + shape.radius_i * (i.phi - j.phi);
  const double radius_j = rolling_radius_j(shape);
  return shape.radius_i * i.phi + radius_j * j.phi - (shape.radius_i + radius_j) * at.centres;
}

Vec velocity_at(Vec point, const Placed& link, const Speeds& speed) {
  return speed.origin + speed.omega * normal(point - link.origin);
}

void turn_centres(PairPlace& at) {
  const double angle = std::atan2(-at.apart.y, -at.apart.x);
  at.centres = angle + whole_turn * std::round((at.centres - angle) / whole_turn);
}

/// The tangent of the belt from wheel i to wheel j: the span that wheel i pays out when it turns clockwise.
void place_belt(const PairShape& shape, PairPlace& at) {
  const double distance = std::sqrt(dot(at.apart, at.apart));
  const Vec e = (-1.0 / distance) * at.apart;
  const double sine = (shape.radius_i - shape.radius_j) / distance;
  const double cosine = std::sqrt(1.0 - sine * sine);
  at.along = cosine * e - sine * normal(e);
  at.rows[0].e = at.along;
  at.at = at.at + shape.radius_i * normal(at.along);
}

void place_wheels(const PairShape& shape, PairPlace& at) {
  turn_centres(at);
  if (is_joint(shape, JointKind::belt)) return place_belt(shape, at);
  at.along = (-1.0 / (shape.radius_i + shape.radius_j)) * at.apart;
  at.rows[0].e = normal(at.along);
  at.rows[1].e = at.along;
  at.at = at.at + shape.radius_i * at.along;
}

void place_on_line(const PairShape& shape, PairPlace& at) {
  at.rows[0].e = at.along;
  at.rows[1].e = normal(at.along);
  at.at = at.at - shape.radius_i * normal(at.along);
}

}  // namespace

PairShape shape_of(const Joint& joint) {
  return {.joint = joint.kind,
          .point_i = joint.point_i,
          .point_j = joint.point_j,
          .line = turn(joint.direction)({1.0, 0.0}),
          .angle = joint.angle,
          .turned = turn(joint.angle),
          .radius_i = joint.radius_i,
          .radius_j = joint.radius_j,
          .phase = joint.phase};
}

PairShape shape_of(const Driver& driver, const Joint* joint) {
  PairShape shape = joint == nullptr ? PairShape{} : shape_of(*joint);
  shape.kind = driver.kind == Driver::Kind::rotary ? PairShape::Kind::turning_drive : PairShape::Kind::sliding_drive;
  shape.offset = driver.offset;
  return shape;
}

RowPattern pattern_of(const PairShape& shape, std::size_t row) {
  if (holds_pin(shape) && row < 2) return {row == 0, row == 1, true};
  const bool turning = shape.kind == PairShape::Kind::turning_drive || is_joint(shape, JointKind::rigid) ||
                       (is_joint(shape, JointKind::prismatic) && row == 1);
  return {!turning, !turning, true};
}

void prepare(const PairShape& shape, PairPlace& at) {
  if (holds_pin(shape)) at.rows = {PairRow{{1.0, 0.0}}, PairRow{{0.0, 1.0}}, PairRow{{}, 1.0}};
  if (shape.kind == PairShape::Kind::turning_drive) at.rows[0].m = 1.0;
  if (is_joint(shape, JointKind::prismatic)) at.rows[1].m = 1.0;
}

void place(const PairShape& shape, const Placed& i, const Placed& j, PairPlace& at) {
  at.at = i.point(shape.point_i);
  at.at_j = at.seat = j.point(shape.point_j);
  at.apart = at.at - at.seat;
  if (holds_pin(shape) || shape.kind == PairShape::Kind::turning_drive) return;
  at.along = j.turned(shape.line);
  if (has_two_wheels(shape)) {
    place_wheels(shape, at);
  } else if (has_wheel_on_line(shape)) {
    place_on_line(shape, at);
  } else {
    at.rows[0].e = shape.kind == PairShape::Kind::sliding_drive ? at.along : normal(at.along);
  }
  at.at_j = at.at;
}

void count_turns(const PairShape& shape, const Placed& i, const Placed& j, PairPlace& at) {
  if (!has_two_wheels(shape)) return;
  const double turn = whole_turn * (shape.radius_i + rolling_radius_j(shape));
  if (turn != 0.0) at.centres += whole_turn * std::round((rolled(shape, at, i, j) - shape.phase) / turn);
}

void take_phases(Model& model) {
  const auto placed = [&](int link) {
    if (link == ground) return Placed{};
    const Pose& pose = model.links[static_cast<std::size_t>(link)].pose;
    return Placed{turn(pose.phi), {pose.x, pose.y}, pose.phi};
  };
  for (Joint& joint : model.joints) {
    const PairShape shape = shape_of(joint);
    if (!has_two_wheels(shape) && !has_wheel_on_line(shape)) continue;
    PairPlace at;
    place(shape, placed(joint.i), placed(joint.j), at);
    joint.phase = rolled(shape, at, placed(joint.i), placed(joint.j));
  }
}

void open(const PairShape& shape, const PairPlace& at, const Placed& i, const Placed& j, double target,
          std::span<double> residual) {
  const double turned = i.phi - j.phi;
  if (shape.kind == PairShape::Kind::turning_drive) {
    residual[0] = turned + shape.offset - target;
  } else if (shape.kind == PairShape::Kind::sliding_drive) {
    residual[0] = dot(at.along, at.apart) + shape.offset - target;
  } else if (holds_pin(shape)) {
    residual[0] = at.apart.x;
    residual[1] = at.apart.y;
    if (residual.size() == 3) residual[2] = turned - shape.angle;
  } else if (on_line(shape)) {
    residual[0] = dot(normal(at.along), at.apart);
    if (residual.size() == 2) residual[1] = turned - shape.angle;
  } else {
    residual[0] = rolled(shape, at, i, j) - shape.phase;
    if (is_joint(shape, JointKind::belt)) residual[0] = -residual[0];
    if (is_joint(shape, JointKind::rolling_on_line)) residual[1] = dot(normal(at.along), at.apart) - shape.radius_i;
    if (is_joint(shape, JointKind::rolling)) {
      const double sum = shape.radius_i + shape.radius_j;
      residual[1] = sum - std::copysign(std::sqrt(dot(at.apart, at.apart)), sum);
    }
  }
}

void held_acceleration(const PairShape& shape, const PairPlace& at, const Placed& i, const Placed& j,
                       const Speeds& speed_i, const Speeds& speed_j, std::span<double> along) {
  for (double& a : along) a = 0.0;
  if (on_line(shape)) {  // Coriolis
    const Vec sliding = velocity_at(at.at, i, speed_i) - velocity_at(at.at, j, speed_j);
    along[0] = 2.0 * speed_j.omega * dot(at.along, sliding);
  } else if (is_joint(shape, JointKind::belt)) {
    // The row is taken at one end of the span: as the span turns, and link j under it, the other end falls behind.
    const Vec centre_i = at.seat + at.apart;
    const Vec apart = velocity_at(centre_i, i, speed_i) - velocity_at(at.seat, j, speed_j);
    const double centres = cross(at.apart, apart) / dot(at.apart, at.apart);
    along[0] = dot(at.along, at.seat - at.at) * (centres * centres - speed_j.omega * speed_j.omega);
  } else if (is_joint(shape, JointKind::rolling_on_line)) {
    const double omega = speed_i.omega - speed_j.omega;
    along[1] = shape.radius_i * omega * omega;
  } else if (is_joint(shape, JointKind::rolling)) {
    const double sum = shape.radius_i + shape.radius_j;
    const double centres = (shape.radius_i * speed_i.omega + shape.radius_j * speed_j.omega) / sum;
    along[1] = sum * centres * centres - shape.radius_i * speed_i.omega * speed_i.omega -
               shape.radius_j * speed_j.omega * speed_j.omega;
  }
}

}  // namespace loadpath::mechanism
