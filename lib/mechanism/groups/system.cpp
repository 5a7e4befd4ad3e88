#include "lib/mechanism/groups/system.hpp"

#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/groups/chain.hpp"
#include "lib/mechanism/groups/chain_forces.hpp"
#include "lib/mechanism/groups/chain_motion.hpp"
#include "lib/mechanism/groups/chain_output.hpp"
#include "lib/mechanism/groups/motion.hpp"
#include "lib/mechanism/groups/plan.hpp"
#include "lib/mechanism/groups/positions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace loadpath::mechanism {

struct GroupSystem::Work {
  explicit Work(const Model& given)
      : model(given),
        length(characteristic_length(given)),
        plan(plan_of(given)),
        chain(chain_of(model, plan)),
        positions(plan, length),
        motion(model, plan, positions),
        induced(model),
        whole(given),
        held(given.links.size()),
        reached(given.links.size()),
        drives(given.drivers.size()),
        way(given.drivers.size()) {
    iterates = std::ranges::any_of(plan.groups, [](const auto& g) { return g.closing == Closing::by_newton; });
    if (chain) now.emplace(*chain);
    first_points.reserve(given.links.size() + 1);
  }

  Status go_to(std::span<const Drive> goal);
  bool go_by_groups(std::span<const Drive> goal);
  double find_way(std::span<const Drive> goal);
  [[nodiscard]] double change(std::span<const Drive> from, std::span<const Drive> to) const;
  void take_dimensions(const Model& given);
  Status adopt();
  void take_sides();
  void hold(std::span<const Drive> goal);
  void find_tendency(std::span<const Drive> goal, Position& out);
  void store(Position& out) const;
  bool find_forces(bool statics, Position& out);

  bool go_by_chain(std::span<const Drive> goal);
  void solve_chain(std::span<const Drive> goal, bool statics, Position& out);
  void store_chain(std::span<const Drive> goal, Position& out);

  Model model;
  double length;
  Plan plan;
  std::optional<Chain> chain;  // if the mechanism is one: replaces positions and motion, except for long moves
  std::optional<ChainState<1>> now;
  GroupPositions positions;
  GroupMotion motion;
  InducedForces induced;
  WholeSystem whole;
  std::vector<Pose> held, reached;
  std::vector<Drive> drives;  // drives of the current position
  std::vector<Drive> way;     // to the goal, as if it took the time 1
  bool iterates = false;      // some group is closed by iteration
  bool closed = false;
  bool in_steps = false;
  FrictionTaken friction;
  std::vector<std::optional<Vec>> first_points;  // points of the links, to find the length
};

GroupSystem::GroupSystem(const Model& model) : work_(std::make_unique<Work>(model)) {}
GroupSystem::~GroupSystem() = default;
GroupSystem::GroupSystem(GroupSystem&&) noexcept = default;

void GroupSystem::take_dimensions(const Model& model) {
  if (work_->chain && is_chain(model)) return work_->take_dimensions(model);
  const FrictionTaken friction = work_->friction;
  work_ = std::make_unique<Work>(model);
  work_->friction = friction;
}

void GroupSystem::Work::take_dimensions(const Model& given) {
  model = given;
  length = characteristic_length(given, first_points);
  mechanism::take_dimensions(model, plan);
  chain->take_dimensions(model, plan);
  positions.take_length(length);
  whole.take_dimensions(given, length);
  closed = false;
}

Status GroupSystem::assemble() {
  Work& w = *work_;
  w.closed = false;
  if (const Status status = w.whole.assemble(); status != Status::closed) return status;
  for (std::size_t k = 0; k < w.drives.size(); ++k) w.drives[k].coordinate = w.whole.coordinate(k);
  w.whole.store_poses(w.held);
  return w.adopt();
}

Status GroupSystem::hold(std::span<const Pose> poses, std::span<const Drive> drives) {
  Work& w = *work_;
  std::ranges::copy(poses, w.held.begin());
  std::ranges::copy(drives, w.drives.begin());
  return w.adopt();
}

double GroupSystem::coordinate(std::size_t driver) const { return work_->drives[driver].coordinate; }

Status GroupSystem::solve(std::span<const Drive> drives, Position& out, bool statics) {
  Work& w = *work_;
  if (w.go_by_chain(drives)) {
    w.solve_chain(drives, statics, out);
    return Status::closed;
  }
  if (const Status status = w.go_to(drives); status != Status::closed) return status;
  const bool rubs = !w.induced.none();
  if (rubs && !moves(drives)) w.find_tendency(drives, out);
  w.motion.find_velocities(drives);
  w.motion.find_accelerations(drives);
  w.store(out);
  if (rubs && moves(drives)) std::ranges::copy(out.velocity, out.tendency.begin());
  return w.find_forces(statics, out) ? Status::closed : Status::jams;
}

Status GroupSystem::solve_motion(std::span<const Drive> drives, Position& out) {
  Work& w = *work_;
  if (w.go_by_chain(drives)) {
    w.store_chain(drives, out);
    return Status::closed;
  }
  if (const Status status = w.go_to(drives); status != Status::closed) return status;
  w.motion.find_velocities(drives);
  w.motion.find_accelerations(drives);
  w.store(out);
  return Status::closed;
}

/// Takes the current position to the groups.
Status GroupSystem::Work::adopt() {
  positions.adopt(held);
  closed = positions.factor();
  take_sides();
  return closed ? Status::closed : Status::singular;
}

Status GroupSystem::Work::go_to(std::span<const Drive> goal) {
  if (!closed) return Status::does_not_close;
  in_steps = chain || !go_by_groups(goal);
  if (!in_steps) {
    hold(goal);
    return Status::closed;
  }
  // `held` is where the groups were.
  whole.hold(held, drives);
  const Status status = whole.move(goal);
  if (status == Status::closed) {
    whole.store_poses(reached);
    positions.adopt(reached);
    if (positions.factor()) {
      take_sides();
      std::ranges::copy(goal, drives.begin());
      std::ranges::copy(reached, held.begin());
      return status;
    }
  }
  adopt();  // back where it was
  return status == Status::closed ? Status::singular : status;
}

bool GroupSystem::Work::go_by_groups(std::span<const Drive> goal) {
  const double change = find_way(goal);
  if (!(change < longest_way)) return false;
  if (iterates) {
    motion.find_velocities(way);
    motion.find_accelerations(way);
  }
  return positions.move(goal, change, motion.rates()) && positions.factor();
}

void GroupSystem::Work::take_sides() {
  if (!chain) return;
  for (std::size_t s = 0; s < chain->steps.size(); ++s) now->sides[s] = positions.branch(chain->steps[s].group);
}

/// Only positions: the forces follow. False if it has to be followed in small steps.
bool GroupSystem::Work::go_by_chain(std::span<const Drive> goal) {
  if (!chain || !closed) return false;
  const double change = find_way(goal);
  if (!(change < longest_way)) return false;
  now->least_sine[0] = near_change + change;
  for (std::size_t s = 0; s < chain->steps.size(); ++s) {
    const ChainStep& step = chain->steps[s];
    if (step.driver != none) set_drive(step, goal[step.driver], 0, now->drives[s]);
  }
  ChainMover<1>(*chain, *now).move();
  return now->clear[0] != 0.0;
}

/// After the move.
void GroupSystem::Work::solve_chain(std::span<const Drive> goal, bool statics, Position& out) {
  for (std::size_t n = 0; n < model.loads.size(); ++n) {
    now->loads[n].force.set(0, model.loads[n].force);
    now->loads[n].moment[0] = model.loads[n].moment;
    out.loads[n] = {model.loads[n].force, model.loads[n].moment};
  }
  ChainForces<1>(*chain, *now).find(statics);
  store_chain(goal, out);
  for (std::size_t k = 0; k < out.reactions.size(); ++k) {
    const ReactionLanes<1>& r = now->reactions[k];
    out.reactions[k].force = r.force[0];
    out.reactions[k].couple = r.couple[0];
    out.reactions[k].touch = Profile::anywhere;
  }
  take_pins(*chain, *now, 0, out.reactions);
  for (std::size_t d = 0; d < out.effort.size(); ++d) out.effort[d] = now->effort[d][0];
}

/// The motion after the move.
void GroupSystem::Work::store_chain(std::span<const Drive> goal, Position& out) {
  follow_poses(*chain, *now, 0, held);
  std::ranges::copy(goal, drives.begin());
  in_steps = false;
  for (std::size_t k = 0; k < held.size(); ++k) {
    out.pose[k] = held[k];
    out.velocity[k] = velocity_of(*chain, *now, k, 0);
    out.acceleration[k] = acceleration_of(*chain, *now, k, 0);
  }
}

double GroupSystem::Work::find_way(std::span<const Drive> goal) {
  for (std::size_t k = 0; k < goal.size(); ++k) way[k].speed = goal[k].coordinate - drives[k].coordinate;
  return change(drives, goal);
}

double GroupSystem::Work::change(std::span<const Drive> from, std::span<const Drive> to) const {
  const auto way_of = [&](std::size_t k) { return to[k].coordinate - from[k].coordinate; };
  double most = 0.0;
  for (std::size_t k = 0; k < to.size(); ++k) {
    const bool linear = model.drivers[k].kind == Driver::Kind::linear;
    const double share = linear ? std::abs(way_of(k)) / length : std::abs(way_of(k));
    if (share > most || std::isnan(share)) most = share;  // NaN stays
  }
  return most;
}

void GroupSystem::Work::hold(std::span<const Drive> goal) {
  std::ranges::copy(goal, drives.begin());
  for (std::size_t k = 0; k < held.size(); ++k) {
    const Placed& link = positions.link(k);
    held[k] = {link.origin.x, link.origin.y, link.phi};
  }
}

void GroupSystem::Work::find_tendency(std::span<const Drive> goal, Position& out) {
  for (std::size_t k = 0; k < goal.size(); ++k) way[k].speed = goal[k].impending;
  motion.find_velocities(way);
  for (std::size_t k = 0; k < held.size(); ++k) {
    const Moving& m = motion.link(k);
    out.tendency[k] = {m.velocity.x, m.velocity.y, m.omega};
  }
}

void GroupSystem::Work::store(Position& out) const {
  for (std::size_t k = 0; k < held.size(); ++k) {
    const Moving& m = motion.link(k);
    out.pose[k] = held[k];
    out.velocity[k] = {m.velocity.x, m.velocity.y, m.omega};
    out.acceleration[k] = {m.acceleration.x, m.acceleration.y, m.epsilon};
  }
  for (std::size_t n = 0; n < out.loads.size(); ++n) out.loads[n] = {model.loads[n].force, model.loads[n].moment};
}

bool GroupSystem::Work::find_forces(bool statics, Position& out) {
  if (!induced.none()) {
    return induced.solve(
        out, [&](const Induced& modes) { motion.find_forces(statics, modes, out); }, friction);
  }
  motion.find_forces(statics, {}, out);
  return true;
}

bool GroupSystem::followed_in_steps() const { return work_->in_steps; }

bool GroupSystem::some_joint_rests() const { return work_->induced.some_rest(); }

void GroupSystem::take_friction(FrictionTaken taken) { work_->friction = taken; }

void GroupSystem::set_load(std::size_t load, Vec force, double moment) {
  work_->model.loads[load].force = force;
  work_->model.loads[load].moment = moment;
}

const Chain* GroupSystem::chain() const { return work_->chain ? &*work_->chain : nullptr; }

std::span<const double> GroupSystem::sides() const {
  return work_->now ? std::span<const double>(work_->now->sides) : std::span<const double>();
}

double GroupSystem::change(std::span<const Drive> from, std::span<const Drive> to) const {
  return work_->change(from, to);
}

Gap GroupSystem::gap() const { return work_->whole.gap(); }

}  // namespace loadpath::mechanism
