#include "lib/mechanism/studies/relative_motion.hpp"

#include "lib/mechanism/model/point_motion.hpp"

namespace loadpath::mechanism {
namespace {

struct LinkState {
  Pose pose, velocity, acceleration;
  [[nodiscard]] Vec origin() const { return {pose.x, pose.y}; }
  [[nodiscard]] Vec velocity_at(Vec place) const { return point_velocity(velocity, place - origin()); }
  [[nodiscard]] Vec acceleration_at(Vec place) const {
    return point_acceleration(acceleration, velocity.phi, place - origin());
  }
};

LinkState state_of(const Position& at, int link) {
  if (link == ground) return {};
  const auto k = static_cast<std::size_t>(link);
  return {at.pose[k], at.velocity[k], at.acceleration[k]};
}

}  // namespace

bool is_guided(const Joint& joint) { return joint.kind == JointKind::slot || joint.kind == JointKind::prismatic; }

RelativeMotion relative_motion(const Joint& joint, const Position& at) {
  const LinkState i = state_of(at, joint.i), j = state_of(at, joint.j);
  const Turn turned = turn(j.pose.phi);
  const Vec pin = i.origin() + turn(i.pose.phi)(joint.point_i);
  RelativeMotion motion;
  motion.along = turned(turn(joint.direction)({1.0, 0.0}));
  motion.s = dot(motion.along, pin - j.origin() - turned(joint.point_j));
  motion.v_e = j.velocity_at(pin);
  motion.s_dot = dot(motion.along, i.velocity_at(pin) - motion.v_e);
  motion.v_r = motion.s_dot * motion.along;
  motion.a_e = j.acceleration_at(pin);
  motion.a_C = 2.0 * j.velocity.phi * normal(motion.v_r);
  motion.s_ddot = dot(motion.along, i.acceleration_at(pin) - motion.a_e - motion.a_C);
  motion.a_r = motion.s_ddot * motion.along;
  return motion;
}

}  // namespace loadpath::mechanism
