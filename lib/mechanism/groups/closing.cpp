#include "lib/mechanism/groups/closing.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {
namespace {

using Kind = DyadClosing::Kind;

Turn turned(std::span<const Pose> poses, int link) {
  return link == ground ? Turn{} : turn(poses[static_cast<std::size_t>(link)].phi);
}

/// The joint's pin, where the mechanism is.
Vec pin_of(const Joint& joint, std::span<const Pose> poses) {
  if (joint.i == ground) return joint.point_i;
  const Pose& pose = poses[static_cast<std::size_t>(joint.i)];
  return Vec{pose.x, pose.y} + turn(pose.phi)(joint.point_i);
}

Vec along(const Joint& joint, std::span<const Pose> poses) {
  return turned(poses, joint.j)(turn(joint.direction)({1.0, 0.0}));
}

bool turns(const Plan& plan, std::size_t tree) { return tree != none && plan.tree[tree].kind == TreeJoint::Kind::turn; }

/// Two circles, or a circle and a line; two lines have one assembly.
bool read_paths(const Plan& plan, const GroupPlan& group, DyadClosing& dyad) {
  const auto joint = [&](std::size_t tree) { return tree == none ? dyad.joint : plan.tree[tree].joint; };
  const bool turns_i = turns(plan, group.mover_i), turns_j = turns(plan, group.mover_j);
  if (!turns_i && !turns_j) return false;
  const std::size_t of_i = joint(group.mover_i), of_j = joint(group.mover_j);
  dyad.first = std::min(of_i, of_j);
  dyad.second = std::max(of_i, of_j);
  if (turns_i && turns_j) return true;
  dyad.kind = Kind::arm_and_line;
  dyad.first = turns_i ? of_i : of_j;
  dyad.second = dyad.line = turns_i ? of_j : of_i;
  return true;
}

bool read(const Plan& plan, const GroupPlan& group, DyadClosing& dyad) {
  if (group.closing == Closing::two_paths) return read_paths(plan, group, dyad);
  const bool about_pin = group.closing == Closing::slot_about_pin;
  if (!about_pin && group.closing != Closing::slide_of_two_turns) return false;
  dyad.kind = Kind::pivots_along_line;
  dyad.line = dyad.joint;
  dyad.first = about_pin ? dyad.joint : plan.tree[group.mover_i].joint;
  dyad.second = plan.tree[group.mover_j].joint;
  return true;
}

}  // namespace

std::vector<DyadClosing> dyad_closings(const Model&, const Plan& plan) {
  std::vector<DyadClosing> dyads;
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    const GroupPlan& group = plan.groups[g];
    if (group.first_cut == group.last_cut) continue;
    DyadClosing dyad{.group = g, .joint = plan.cuts[group.first_cut].joint};
    if (read(plan, group, dyad)) dyads.push_back(dyad);
  }
  return dyads;
}

ClosingAngle closing_angle(const Model& model, const DyadClosing& dyad, std::span<const Pose> poses) {
  const auto pin = [&](std::size_t joint) { return pin_of(model.joints[joint], poses); };
  const bool between = dyad.kind == Kind::pivots_along_line;
  const Vec arm = between ? pin(dyad.first) - pin(dyad.second) : pin(dyad.joint) - pin(dyad.first);
  if (length(arm) == 0.0) return {0.0, 1.0};  // the pin is at the pivot: nothing is transmitted
  const double inverse = 1.0 / length(arm);
  if (dyad.kind == Kind::two_arms) {
    const Vec other = pin(dyad.joint) - pin(dyad.second);
    const double both = inverse / length(other);
    return {both * cross(arm, other), both * dot(arm, other)};
  }
  const Vec line = along(model.joints[dyad.line], poses);
  return {inverse * dot(line, arm), inverse * cross(line, arm)};
}

std::string side_name(const Model& model, const DyadClosing& dyad, double sine) {
  const bool arms = dyad.kind == Kind::two_arms;
  const char* side = sine < 0.0 ? (arms ? "_right" : "_behind") : (arms ? "_left" : "_ahead");
  return model.joints[dyad.joint].name + side;
}

double transmission_angle(const ClosingAngle& angle) {
  return std::atan2(std::abs(angle.sine), std::abs(angle.cosine));
}

}  // namespace loadpath::mechanism
