#include "lib/mechanism/studies/member.hpp"

#include "lib/mechanism/model/point_motion.hpp"
#include "lib/mechanism/model/spring.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::mechanism {
namespace {

Vec point_on(const Joint& joint, std::size_t link) {
  return joint.i == static_cast<int>(link) ? joint.point_i : joint.point_j;
}

std::vector<std::size_t> joints_at(const Model& model, std::size_t link) {
  const int own = static_cast<int>(link);
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    if (model.joints[k].i == own || model.joints[k].j == own) found.push_back(k);
  }
  return found;
}

/// The values of x between 0 and `most` where a + b x + c x^2 is zero.
void add_roots(double a, double b, double c, double most, std::vector<double>& roots) {
  const auto add = [&](double x) {
    if (x > 0.0 && x < most) roots.push_back(x);
  };
  if (c == 0.0) {
    if (b != 0.0) add(-a / b);
    return;
  }
  const double discriminant = b * b - 4.0 * a * c;
  if (discriminant < 0.0) return;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  add(q / c);
  if (q != 0.0) add(a / q);
}

}  // namespace

bool is_uniform(const Model& model, const Member& member) {
  const Link& link = model.links[member.link];
  const double l = member.length(), J = link.mass * l * l / 12.0;
  const Vec middle = 0.5 * (member.start + member.end);
  return std::abs(link.inertia - J) <= 0.01 * J && length(link.centre - middle) <= 0.01 * l;
}

Member member_of(const Model& model, std::size_t link) {
  Member member{.link = link, .start = {}, .end = {}};
  const std::vector<std::size_t> joints = joints_at(model, link);
  for (const std::size_t a : joints) {
    for (const std::size_t b : joints) {
      const Vec start = point_on(model.joints[a], link), end = point_on(model.joints[b], link);
      if (length(end - start) <= member.length()) continue;
      member.start = start;
      member.end = end;
    }
  }
  return member;
}

MemberLoads::MemberLoads(const Model& model, const Member& member)
    : model_(model), member_(member), joints_(joints_at(model, member.link)), length_(member.length()) {}

void MemberLoads::take(const Position& at, bool statics) {
  const Pose& pose = at.pose[member_.link];
  const Turn link = turn(pose.phi);
  turned_ = link * turn({1.0, 0.0}, (1.0 / length_) * (member_.end - member_.start));
  origin_ = Vec{pose.x, pose.y} + link(member_.start);
  actions_.clear();
  first_ = slope_ = {};
  add_mass(at, statics);
  add_loads(at);
  add_joints(at);
  add_drives(at);
  sum_up();
}

// On the axis at the foot of the perpendicular, with the moment about it.
void MemberLoads::add(Vec place, Vec force, double couple) {
  const Vec own = turned_.back()(place - origin_), along = turned_.back()(force);
  const double x = std::clamp(own.x, 0.0, length_);
  actions_.push_back({x, along, couple + cross(own - Vec{x, 0.0}, along)});
}

void MemberLoads::add_mass(const Position& at, bool statics) {
  const Link& link = model_.links[member_.link];
  const Pose &pose = at.pose[member_.link], &v = at.velocity[member_.link], &a = at.acceleration[member_.link];
  const Acceleration moving = statics ? Acceleration{} : Acceleration{{a.x, a.y}, v.phi, a.phi};
  const Vec frame{pose.x, pose.y}, centre = frame + turn(pose.phi)(link.centre);
  const Wrench needed = inertia_less_weight(link, turn(pose.phi), moving, model_.gravity);
  const double couple = -link.inertia * moving.epsilon;
  if (member_.mass == MassLine::uniform) {
    spread_mass(moving, origin_ - frame);
    const Vec spread = turned_(length_ * first_ + 0.5 * length_ * length_ * slope_);
    const double moment = length_ * length_ * (0.5 * first_.y + slope_.y * length_ / 3.0);
    // The deviation of the link's own mass centre and moment of inertia from those of the bar.
    add(origin_, -needed.force - spread, couple - cross(centre - origin_, needed.force) - moment);
  } else {
    add(centre, -needed.force, couple);
  }
}

// The force of inertia and the weight, per length, of a point at x.
void MemberLoads::spread_mass(const Acceleration& moving, Vec arm) {
  const Vec start = point_acceleration({moving.origin.x, moving.origin.y, moving.epsilon}, moving.omega, arm);
  const double density = model_.links[member_.link].mass / length_;
  first_ = -density * turned_.back()(start - model_.gravity);
  slope_ = -density * Vec{-moving.omega * moving.omega, moving.epsilon};
}

void MemberLoads::add_loads(const Position& at) {
  const Pose& pose = at.pose[member_.link];
  const Turn link = turn(pose.phi);
  for (std::size_t n = 0; n < model_.loads.size(); ++n) {
    const Load& load = model_.loads[n];
    if (load.link != static_cast<int>(member_.link)) continue;
    const LoadNow& now = at.loads[n];
    add(Vec{pose.x, pose.y} + link(load.point), global_force(load, now.force, link), now.moment);
  }
  for (const Spring& spring : model_.springs) {
    const SpringNow now = spring_now(spring, at);
    if (spring.i == static_cast<int>(member_.link)) add(now.at_i, now.force, now.couple);
    if (spring.j == static_cast<int>(member_.link)) add(now.at_j, -now.force, -now.couple);
  }
}

void MemberLoads::add_joints(const Position& at) {
  for (const std::size_t k : joints_) {
    const Joint& joint = model_.joints[k];
    const double sense = joint.i == static_cast<int>(member_.link) ? 1.0 : -1.0;
    const Reaction& reaction = at.reactions[k];
    add(reaction.at, sense * reaction.force, sense * reaction.couple);
  }
}

// The couple of a rotary drive acts at the pin that joins its two links, or, where none does, at the start.
void MemberLoads::add_drives(const Position& at) {
  for (std::size_t d = 0; d < model_.drivers.size(); ++d) {
    const Driver& driver = model_.drivers[d];
    const bool linear = driver.kind == Driver::Kind::linear;
    const auto same = [&](const Joint& j) {
      if (j.kind != JointKind::revolute) return false;
      return (j.i == driver.i && j.j == driver.j) || (j.i == driver.j && j.j == driver.i);
    };
    const auto found = linear ? model_.joints.begin() + driver.joint : std::ranges::find_if(model_.joints, same);
    const bool joined = found != model_.joints.end();
    const int i = linear ? found->i : driver.i, j = linear ? found->j : driver.j;
    const int link = static_cast<int>(member_.link);
    if (i != link && j != link) continue;
    const double sense = i == link ? 1.0 : -1.0;
    const Vec place = joined ? at.reactions[static_cast<std::size_t>(found - model_.joints.begin())].at : origin_;
    if (!linear) {
      add(place, {}, sense * at.effort[d]);
      continue;
    }
    const double on = found->j == ground ? 0.0 : at.pose[static_cast<std::size_t>(found->j)].phi;
    add(place, sense * at.effort[d] * turn(on + found->direction)({1.0, 0.0}), 0.0);
  }
}

void MemberLoads::sum_up() {
  std::ranges::stable_sort(actions_, {}, &Action::x);
  stations_.assign(1, {});
  const double together = 1e-9 * length_;  // as the pins of a compound hinge: without material between them
  for (std::size_t k = 0; k < actions_.size(); ++k) {
    const bool elsewhere = k == 0 || actions_[k].x - stations_.back().x > together;
    if (actions_[k].x - stations_.back().x > together) stations_.push_back(further(stations_.back(), actions_[k].x));
    if (elsewhere) stations_.push_back(stations_.back());
    SectionForces& after = stations_.back();
    after.N -= actions_[k].force.x;
    after.V += actions_[k].force.y;
    after.M -= actions_[k].couple;
  }
  if (stations_.back().x < length_) stations_.push_back(further(stations_.back(), length_));
}

// Between places where something acts only the mass does.
SectionForces MemberLoads::further(const SectionForces& from, double x) const {
  const double d = x - from.x;
  const Vec here = first_ + from.x * slope_;
  return {x, from.N - (here.x + 0.5 * slope_.x * d) * d, from.V + (here.y + 0.5 * slope_.y * d) * d,
          from.M + (from.V + (0.5 * here.y + slope_.y * d / 6.0) * d) * d};
}

SectionForces MemberLoads::at(double x) const {
  SectionForces before = stations_.front();
  for (const SectionForces& station : stations_) {
    if (station.x <= x) before = station;
  }
  return further(before, x);
}

MemberLoads::Peaks MemberLoads::peaks() const {
  Peaks peaks;
  const auto take = [&](const SectionForces& s) {
    if (std::abs(s.N) > std::abs(peaks.N.N)) peaks.N = s;
    if (std::abs(s.V) > std::abs(peaks.V.V)) peaks.V = s;
    if (std::abs(s.M) > std::abs(peaks.M.M)) peaks.M = s;
  };
  std::vector<double> inside;
  for (std::size_t k = 0; k < stations_.size(); ++k) {
    const SectionForces& from = stations_[k];
    take(from);
    if (k + 1 == stations_.size() || stations_[k + 1].x <= from.x) continue;
    const double most = stations_[k + 1].x - from.x;
    const Vec here = first_ + from.x * slope_;
    inside.clear();
    add_roots(here.x, slope_.x, 0.0, most, inside);
    add_roots(here.y, slope_.y, 0.0, most, inside);
    add_roots(from.V, here.y, 0.5 * slope_.y, most, inside);
    for (const double d : inside) take(further(from, from.x + d));
  }
  return peaks;
}

}  // namespace loadpath::mechanism
