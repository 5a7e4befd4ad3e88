#include "calculators/mechanism/pictures/animation.hpp"

#include "calculators/mechanism/cycle/point_motion.hpp"
#include "calculators/mechanism/pictures/forces.hpp"
#include "calculators/mechanism/results/output.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace loadpath::planar {

namespace {

using figure::Motion;
using mechanism::Vec;
using Cause = ActingForce::Cause;

constexpr std::size_t most_frames = 360, most_columns_times_frames = 60000, most_numbers = 16;

double largest(const std::vector<figure::Point>& values) {
  double most = 0.0;
  for (const auto& v : values) most = std::max(most, std::hypot(v.x, v.y));
  return most;
}

class Animation {
 public:
  explicit Animation(const AnimationSubject& subject)
      : in_(subject), frames_(frames_of(subject.cycle, subject.governing, frames_that_fit(subject))) {
    motion_ = scheme_at(in_.model, position(shown()), in_.extents, in_.points, Shown::moving);
    add_paths(in_.points, in_.cycle, in_.axis.cyclic(), motion_.still);
    motion_.shown = shown();
    add_links();
    add_arrows();
    add_couples();
    for (std::size_t k = 0; k < in_.model.links.size(); ++k) add_plan(static_cast<int>(k));
    drop_empty_plans();
    add_numbers();
  }
  [[nodiscard]] Motion&& taken() { return std::move(motion_); }

 private:
  static std::size_t frames_that_fit(const AnimationSubject& in) {
    const std::size_t columns = 3 * in.model.links.size() + 3 * in.model.joints.size() + 2 * in.model.links.size();
    return std::clamp<std::size_t>(most_columns_times_frames / std::max<std::size_t>(columns, 1), 24, most_frames);
  }
  [[nodiscard]] const mechanism::Position& position(std::size_t frame) const {
    return in_.cycle.positions[frames_[frame]];
  }
  [[nodiscard]] std::size_t shown() const {
    return static_cast<std::size_t>(std::find(frames_.begin(), frames_.end(), in_.governing) - frames_.begin());
  }

  /// A link's place is given by a point of the picture, not by the origin of its axes, which may be far off.
  void add_links() {
    for (std::size_t k = 0; k < in_.model.links.size(); ++k) {
      const auto& body = motion_.still.bodies[k].points;
      const mechanism::Pose& pose = position(shown()).pose[k];
      const Vec place = body.empty() ? Vec{pose.x, pose.y} : Vec{body.front().x, body.front().y};
      const Vec own = mechanism::turn(pose.phi).back()(place - Vec{pose.x, pose.y});
      Motion::Link link;
      for (std::size_t f = 0; f < frames_.size(); ++f) {
        const int index = static_cast<int>(k);
        link.poses.push_back({point(motion_of(position(f), index, own).place), position(f).pose[k].phi});
      }
      motion_.links.push_back(std::move(link));
    }
  }

  /// The arrows of the scheme: the joints', then those of loads that are forces.
  void add_arrows() {
    for (std::size_t n = 0; n < in_.model.joints.size(); ++n) add_reaction(n);
    std::size_t id = in_.model.joints.size();
    for (std::size_t n = 0; n < in_.model.loads.size(); ++n) {
      if (in_.extents.loads_push[n]) ids_[{Cause::load, n}] = id++;
    }
  }

  void add_reaction(std::size_t n) {
    ids_[{Cause::joint, n}] = n;
    const auto kind = in_.model.joints[n].kind;
    const bool at_pin = kind == mechanism::JointKind::revolute || kind == mechanism::JointKind::prismatic ||
                        kind == mechanism::JointKind::slot || kind == mechanism::JointKind::rigid;
    if (at_pin) return;
    for (std::size_t f = 0; f < frames_.size(); ++f)
      motion_.forces[n].places.push_back(point(position(f).reactions[n].at));
  }

  void add_couples() {
    std::size_t id = 0;
    for (std::size_t n = 0; n < in_.model.loads.size(); ++n) {
      if (!in_.extents.loads_turn[n]) continue;
      for (std::size_t f = 0; f < frames_.size(); ++f)
        motion_.couples[id].values.push_back(position(f).loads[n].moment);
      ++id;
    }
    for (std::size_t d = 0; d < in_.model.drivers.size() && id < motion_.couples.size(); ++d) {
      if (in_.model.drivers[d].kind != mechanism::Driver::Kind::rotary) continue;
      for (std::size_t f = 0; f < frames_.size(); ++f) motion_.couples[id].values.push_back(position(f).effort[d]);
      ++id;
    }
  }

  void add_plan(int link) {
    Motion::LinkPlan plan{in_.model.links[static_cast<std::size_t>(link)].name, {}};
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      const auto acting = acting_on(in_.model, position(f), link, in_.statics);
      for (const ActingForce& a : acting) {
        if (f == 0) plan.sides.push_back(side_of(a));
        auto& values = motion_.forces[ids_.at(key(a))].values;
        if (values.size() == f) values.push_back(point(a.sense * a.force));
      }
    }
    motion_.plans.push_back(std::move(plan));
  }

  using Key = std::pair<Cause, std::size_t>;
  static Key key(const ActingForce& a) { return {a.cause, a.index}; }

  Motion::Side side_of(const ActingForce& a) {
    const auto [found, is_new] = ids_.try_emplace(key(a), motion_.forces.size());
    if (is_new) motion_.forces.emplace_back();
    return {found->second, a.sense, a.name(), a.tone()};
  }

  /// Sides that are zero all the time, then polygons of fewer than two sides; the one with the largest force is shown.
  void drop_empty_plans() {
    double most = 0.0, shown_most = 0.0;
    for (const auto& force : motion_.forces) most = std::max(most, largest(force.values));
    for (auto& plan : motion_.plans) {
      std::erase_if(plan.sides, [&](const auto& s) { return largest(motion_.forces[s.force].values) <= 1e-9 * most; });
    }
    std::erase_if(motion_.plans, [](const auto& plan) { return plan.sides.size() < 2; });
    for (std::size_t k = 0; k < motion_.plans.size(); ++k) {
      double size = 0.0;
      for (const auto& s : motion_.plans[k].sides) size += largest(motion_.forces[s.force].values);
      if (size > shown_most) shown_most = size, motion_.shown_plan = k;
    }
  }

  [[nodiscard]] std::vector<double> at_frames(std::span<const double> series) const {
    std::vector<double> values;
    for (const std::size_t k : frames_) values.push_back(series[k]);
    return values;
  }

  void add_numbers() {
    motion_.axis = {axis_symbol(in_.axis), in_.axis.quantity, in_.axis.unit, at_frames(in_.axis.at.numbers())};
    for (const auto& line : in_.results) {
      const Kind kind = line.kind();
      const bool number = is_effort(kind) || kind == Kind::joint_force;
      if (!number || motion_.numbers.size() == most_numbers) continue;
      const account::Entry& e = *line.entry;
      const std::string symbol =
          kind == Kind::drive_moment ? "M" : (kind == Kind::joint_force ? "R_" : "F_") + line.output->name;
      motion_.numbers.push_back({symbol, e.doc, e.unit, at_frames(e.value.si)});
    }
  }

  const AnimationSubject& in_;
  std::vector<std::size_t> frames_;
  Motion motion_;
  std::map<Key, std::size_t> ids_;
};

}  // namespace

std::vector<std::size_t> frames_of(const Cycle& cycle, std::size_t governing, std::size_t most) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) count += cycle.has_forces(k) ? 1 : 0;
  const std::size_t stride = count <= most ? 1 : (count + most - 1) / most;
  std::vector<std::size_t> frames;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (cycle.has_forces(k) && (k % stride == 0 || k == governing)) frames.push_back(k);
  }
  return frames;
}

figure::Figure animation(const AnimationSubject& subject) {
  return {"peak-position",
          "Mechanism near the position of maximum driving torque or force, with forces and the force polygon "
          "of a link",
          Animation(subject).taken()};
}

}  // namespace loadpath::planar
