#include "lib/mechanism/accuracy/dual_model.hpp"

namespace loadpath::mechanism {
namespace {

BasicVec<Dual> as_dual(Vec v) { return {v.x, v.y}; }
BasicPose<Dual> as_dual(const Pose& p) { return {p.x, p.y, p.phi}; }

BasicLink<Dual> as_dual(const Link& link) {
  return {link.name, link.mass, link.inertia, as_dual(link.centre), as_dual(link.pose)};
}

BasicFriction<Dual> as_dual(const Friction& f) {
  return {f.coefficient, f.pin_radius, f.rolling_arm,    f.viscous,          f.loss,
          f.loss_back,   f.rise,       f.stribeck_speed, f.stribeck_exponent};
}

BasicJoint<Dual> as_dual(const Joint& joint) {
  return {.name = joint.name,
          .kind = joint.kind,
          .i = joint.i,
          .j = joint.j,
          .point_i = as_dual(joint.point_i),
          .point_j = as_dual(joint.point_j),
          .direction = joint.direction,
          .angle = joint.angle,
          .radius_i = joint.radius_i,
          .radius_j = joint.radius_j,
          .pressure_angle = joint.pressure_angle,
          .tension = joint.tension,
          .guide_length = joint.guide_length,
          .guide_width = joint.guide_width,
          .friction = as_dual(joint.friction),
          .phase = joint.phase,
          .contact = joint.contact,
          .profile = joint.profile,
          .metre = joint.metre};
}

BasicDriver<Dual> as_dual(const Driver& d) { return {d.name, d.kind, d.i, d.j, d.joint, d.offset}; }

BasicLoad<Dual> as_dual(const Load& load) {
  return {load.name, load.link, as_dual(load.point), as_dual(load.force), load.turns_with_link, load.moment};
}

BasicSpring<Dual> as_dual(const Spring& spring) {
  return {.name = spring.name,
          .kind = spring.kind,
          .i = spring.i,
          .j = spring.j,
          .point_i = as_dual(spring.point_i),
          .point_j = as_dual(spring.point_j),
          .rate = spring.rate,
          .free = spring.free,
          .damping = spring.damping};
}

}  // namespace

BasicModel<Dual> as_dual(const Model& model) {
  BasicModel<Dual> dual;
  for (const auto& link : model.links) dual.links.push_back(as_dual(link));
  for (const auto& joint : model.joints) dual.joints.push_back(as_dual(joint));
  for (const auto& driver : model.drivers) dual.drivers.push_back(as_dual(driver));
  for (const auto& load : model.loads) dual.loads.push_back(as_dual(load));
  for (const auto& spring : model.springs) dual.springs.push_back(as_dual(spring));
  dual.gravity = as_dual(model.gravity);
  return dual;
}

}  // namespace loadpath::mechanism
