#include "lib/mechanism/proof/balance.hpp"

#include "lib/mechanism/forces/induced.hpp"
#include "lib/mechanism/model/point_motion.hpp"
#include "lib/numerics/magnitude.hpp"

namespace loadpath::mechanism {
namespace {

class Balance {
 public:
  Balance(const Model& model, const Position& at) : model_(model), at_(at), sums_(model.links.size()) {
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      sums_[k].centre = origin(k) + turn(at.pose[k].phi)(model.links[k].centre);
    }
    for (std::size_t k = 0; k < model.joints.size(); ++k) add_joint(k);
  }

  void add(const ActiveForce& active) {
    push(static_cast<int>(active.link), origin(active.link) + active.arm, active.force, active.couple);
    add_power(power(active, at_.velocity[active.link]));
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
    Residuals left{.power = power_, .power_scale = power_scale_};
    left.links.reserve(sums_.size());
    for (const Sum& sum : sums_) {
      left.links.push_back({length(sum.force), std::abs(sum.moment)});
      left.force = numerics::larger_magnitude(left.force, left.links.back().force);
      left.moment = numerics::larger_magnitude(left.moment, left.links.back().moment);
    }
    return left;
  }

 private:
  struct Sum {
    Vec centre;  // about which the moments are taken
    Vec force;
    double moment = 0.0;
  };

  [[nodiscard]] Vec origin(std::size_t link) const { return {at_.pose[link].x, at_.pose[link].y}; }

  void add_power(double power) {
    power_ += power;
    power_scale_ += std::abs(power);
  }

  void push(int link, Vec place, Vec force, double couple) {
    if (link == ground) return;
    Sum& sum = sums_[static_cast<std::size_t>(link)];
    sum.force = sum.force + force;
    sum.moment += couple + cross(place - sum.centre, force);
  }

  void add_joint(std::size_t k) {
    const Reaction& reaction = at_.reactions[k];
    const Joint& joint = model_.joints[k];
    push(joint.i, reaction.at, reaction.force, reaction.couple);
    push(joint.j, reaction.at, -reaction.force, -reaction.couple);
    // An ideal joint does no work: counting it would hide an error.
    if (modes_of(joint) > 0) add_power(power_on(joint.i, reaction) - power_on(joint.j, reaction));
  }

  [[nodiscard]] double power_on(int link, const Reaction& by) const {
    if (link == ground) return 0.0;
    const auto k = static_cast<std::size_t>(link);
    return dot(by.force, point_velocity(at_.velocity[k], by.at - origin(k))) + by.couple * at_.velocity[k].phi;
  }

  const Model& model_;
  const Position& at_;
  std::vector<Sum> sums_;
  double power_ = 0.0;
  double power_scale_ = 0.0;
};

}  // namespace

Residuals residuals(const Model& model, std::span<const Drive> drives, std::span<const ActiveForce> active,
                    const Position& at) {
  Balance balance(model, at);
  for (const ActiveForce& a : active) balance.add(a);
  for (std::size_t k = 0; k < drives.size(); ++k) balance.add_drive(k, drives[k].speed);
  return balance.left();
}

Residuals residuals(const Model& model, std::span<const Drive> drives, bool statics, const Position& at) {
  std::vector<ActiveForce> active;
  find_active_forces(model, at, statics, active);
  return residuals(model, drives, active, at);
}

}  // namespace loadpath::mechanism
