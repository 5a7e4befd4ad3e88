#include "lib/mechanism/kinetostatics.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {
namespace {

Vec at(std::span<const double> q, std::size_t link) { return {q[3 * link], q[3 * link + 1]}; }

Vec global_force(const Load& load, const Turn& turned) {
  return load.turns_with_link ? turned(load.force) : load.force;
}

Vec point_velocity(const Pose& velocity, Vec arm) { return Vec{velocity.x, velocity.y} + velocity.phi * normal(arm); }

Vec point_acceleration(Vec origin, double epsilon, double omega, Vec arm) {
  return origin + epsilon * normal(arm) - omega * omega * arm;
}

}  // namespace

void required_forces(const Model& model, const Constraints& constraints, std::span<const double> velocity,
                     std::span<const double> acceleration, bool statics, std::span<double> required) {
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const Link& link = model.links[k];
    const Vec arm = constraints.turned(k)(link.centre);
    const double epsilon = statics ? 0.0 : acceleration[3 * k + 2];
    const Vec a = statics ? Vec{} : point_acceleration(at(acceleration, k), epsilon, velocity[3 * k + 2], arm);
    const Vec force = link.mass * (a - model.gravity);
    required[3 * k] = force.x;
    required[3 * k + 1] = force.y;
    required[3 * k + 2] = link.inertia * epsilon + cross(arm, force);
  }
  for (const auto& load : model.loads) {
    const auto k = static_cast<std::size_t>(load.link);
    const Vec force = global_force(load, constraints.turned(k));
    required[3 * k] -= force.x;
    required[3 * k + 1] -= force.y;
    required[3 * k + 2] -= load.moment + cross(constraints.turned(k)(load.point), force);
  }
}

void share_out(const Model& model, const Constraints& constraints, std::span<const double> q,
               std::span<const double> multipliers, double length, Position& out) {
  for (std::size_t k = 0; k < out.reactions.size(); ++k) {
    const Pair& pair = constraints.pairs()[k];
    const double first = multipliers[pair.row];
    Reaction& reaction = out.reactions[k];
    reaction.at = length * (at(q, pair.i) + pair.arm_i);
    reaction.couple = 0.0;
    if (pair.kind == JointKind::revolute) {
      reaction.force = length * Vec{first, multipliers[pair.row + 1]};
    } else {
      reaction.force = length * (first * normal(pair.along));
      if (pair.kind == JointKind::prismatic) reaction.couple = length * length * multipliers[pair.row + 1];
    }
  }
  const auto efforts = multipliers.subspan(constraints.first_driver_row());
  for (std::size_t k = 0; k < out.effort.size(); ++k) {
    const bool rotary = model.drivers[k].kind == Driver::Kind::rotary;
    out.effort[k] = (rotary ? length * length : length) * efforts[k];
  }
}

void Balance::check(const Model& model, const Constraints& constraints, std::span<const Drive> drives, bool statics,
                    Position& out) {
  power_ = 0.0;
  power_scale_ = 0.0;
  add_links(model, constraints, statics, out);
  add_loads(model, constraints, out);
  add_joints(constraints, out);
  add_drives(model, constraints, drives, out);
  out.residual_force = 0.0;
  out.residual_moment = 0.0;
  for (const auto& sum : std::span(sums_).first(model.links.size())) {
    out.residual_force = std::max(out.residual_force, length(sum.force));
    out.residual_moment = std::max(out.residual_moment, std::abs(sum.moment));
  }
  out.power_residual = power_;
  out.power_scale = power_scale_;
}

void Balance::Sum::add(Vec at, Vec push, double couple) {
  force = force + push;
  moment += couple + cross(at - centre, push);
}

void Balance::add_power(double power) {
  power_ += power;
  power_scale_ += std::abs(power);
}

void Balance::add_links(const Model& model, const Constraints& constraints, bool statics, const Position& at) {
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const Link& link = model.links[k];
    const Vec arm = constraints.turned(k)(link.centre);
    const Vec velocity = point_velocity(at.velocity[k], arm);
    const Vec centre = Vec{at.pose[k].x, at.pose[k].y} + arm;
    const Pose& a = at.acceleration[k];
    const Vec inertia = statics ? Vec{} : link.mass * point_acceleration({a.x, a.y}, a.phi, at.velocity[k].phi, arm);
    const double couple = statics ? 0.0 : link.inertia * a.phi;
    const Vec weight = link.mass * model.gravity;
    sums_[k] = {centre, weight - inertia, -couple};
    add_power(dot(weight, velocity));
    add_power(-dot(inertia, velocity) - couple * at.velocity[k].phi);
  }
}

void Balance::add_loads(const Model& model, const Constraints& constraints, const Position& at) {
  for (const auto& load : model.loads) {
    const auto k = static_cast<std::size_t>(load.link);
    const Vec arm = constraints.turned(k)(load.point);
    const Vec force = global_force(load, constraints.turned(k));
    sums_[k].add(Vec{at.pose[k].x, at.pose[k].y} + arm, force, load.moment);
    add_power(dot(force, point_velocity(at.velocity[k], arm)) + load.moment * at.velocity[k].phi);
  }
}

void Balance::add_joints(const Constraints& constraints, const Position& at) {
  for (std::size_t k = 0; k < at.reactions.size(); ++k) {
    const Pair& pair = constraints.pairs()[k];
    const Reaction& reaction = at.reactions[k];
    sums_[pair.i].add(reaction.at, reaction.force, reaction.couple);
    sums_[pair.j].add(reaction.at, -reaction.force, -reaction.couple);
  }
}

void Balance::add_drives(const Model& model, const Constraints& constraints, std::span<const Drive> drives,
                         const Position& at) {
  for (std::size_t k = 0; k < drives.size(); ++k) {
    const Driver& driver = model.drivers[k];
    add_power(at.effort[k] * drives[k].speed);
    if (driver.kind == Driver::Kind::rotary) {
      of(driver.i).moment += at.effort[k];
      of(driver.j).moment -= at.effort[k];
      continue;
    }
    const auto joint = static_cast<std::size_t>(driver.joint);
    const Pair& pair = constraints.pairs()[joint];
    const Vec force = at.effort[k] * pair.along;
    sums_[pair.i].add(at.reactions[joint].at, force, 0.0);
    sums_[pair.j].add(at.reactions[joint].at, -force, 0.0);
  }
}

}  // namespace loadpath::mechanism
