#include "lib/mechanism/balance.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {
namespace {

/// A point of a link: where it is, how it moves.
struct Moving {
  Vec place, velocity, acceleration;
};

Moving moving(const Position& at, std::size_t link, Vec point) {
  const Pose &p = at.pose[link], &v = at.velocity[link], &a = at.acceleration[link];
  const Vec arm = turn(p.phi)(point);
  return {Vec{p.x, p.y} + arm, Vec{v.x, v.y} + v.phi * normal(arm),
          Vec{a.x, a.y} + a.phi * normal(arm) - v.phi * v.phi * arm};
}

class Balance {
 public:
  Balance(const Model& model, const Position& at, bool statics) : model_(model), at_(at), sums_(model.links.size()) {
    for (std::size_t k = 0; k < sums_.size(); ++k) add_link(k, statics);
    for (const Load& load : model.loads) add(load);
    for (std::size_t k = 0; k < model.joints.size(); ++k) add_joint(k);
  }

  void add_drive(std::size_t k, double speed) {
    const Driver& driver = model_.drivers[k];
    add_power(at_.effort[k] * speed);
    if (driver.kind == Driver::Kind::rotary) {
      push(driver.i, {}, {}, at_.effort[k]);
      push(driver.j, {}, {}, -at_.effort[k]);
      return;
    }
    const auto joint = static_cast<std::size_t>(driver.joint);
    const Joint& slide = model_.joints[joint];
    const double turned = slide.j == ground ? 0.0 : at_.pose[static_cast<std::size_t>(slide.j)].phi;
    const Vec force = at_.effort[k] * turn(turned + slide.direction)({1.0, 0.0});
    push(slide.i, at_.reactions[joint].at, force, 0.0);
    push(slide.j, at_.reactions[joint].at, -force, 0.0);
  }

  [[nodiscard]] Residuals left() const {
    Residuals left{.force = 0.0, .moment = 0.0, .power = power_, .power_scale = power_scale_};
    for (const Sum& sum : sums_) {
      left.force = std::max(left.force, length(sum.force));
      left.moment = std::max(left.moment, std::abs(sum.moment));
    }
    return left;
  }

 private:
  struct Sum {
    Vec centre;  // about which the moments are taken
    Vec force;
    double moment = 0.0;
  };

  void add_power(double power) {
    power_ += power;
    power_scale_ += std::abs(power);
  }

  /// A force without a place acts at the mass centre.
  void push(int link, Vec place, Vec force, double couple) {
    if (link == ground) return;
    Sum& sum = sums_[static_cast<std::size_t>(link)];
    sum.force = sum.force + force;
    sum.moment += couple + cross(place - sum.centre, force);
  }

  void add_link(std::size_t k, bool statics) {
    const Link& link = model_.links[k];
    const Moving centre = moving(at_, k, link.centre);
    const Vec inertia = statics ? Vec{} : link.mass * centre.acceleration;
    const double couple = statics ? 0.0 : link.inertia * at_.acceleration[k].phi;
    const Vec weight = link.mass * model_.gravity;
    sums_[k] = {centre.place, weight - inertia, -couple};
    add_power(dot(weight, centre.velocity));
    add_power(-dot(inertia, centre.velocity) - couple * at_.velocity[k].phi);
  }

  void add(const Load& load) {
    const auto k = static_cast<std::size_t>(load.link);
    const Moving point = moving(at_, k, load.point);
    const Vec force = load.turns_with_link ? turn(at_.pose[k].phi)(load.force) : load.force;
    push(load.link, point.place, force, load.moment);
    add_power(dot(force, point.velocity) + load.moment * at_.velocity[k].phi);
  }

  void add_joint(std::size_t k) {
    const Reaction& reaction = at_.reactions[k];
    push(model_.joints[k].i, reaction.at, reaction.force, reaction.couple);
    push(model_.joints[k].j, reaction.at, -reaction.force, -reaction.couple);
  }

  const Model& model_;
  const Position& at_;
  std::vector<Sum> sums_;
  double power_ = 0.0;
  double power_scale_ = 0.0;
};

}  // namespace

Residuals residuals(const Model& model, std::span<const Drive> drives, bool statics, const Position& at) {
  Balance balance(model, at, statics);
  for (std::size_t k = 0; k < drives.size(); ++k) balance.add_drive(k, drives[k].speed);
  return balance.left();
}

}  // namespace loadpath::mechanism
