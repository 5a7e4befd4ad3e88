#include "lib/mechanism/groups/released_system.hpp"

#include "lib/mechanism/structure/free_mechanism.hpp"
#include "lib/mechanism/structure/release.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace loadpath::mechanism {
namespace {

// Relative to the unit of length, or rad: more than the rounding error of a closed joint.
constexpr double closed = 1e-9;
// Share of the grip when the release was chosen, below which it is chosen again.
constexpr double enough = 0.3;

Model without_drivers(Model model) {
  model.drivers.clear();
  return model;
}

}  // namespace

struct ReleasedSystem::Work {
  Work(const Model& stated, bool held_too_much)
      : given(stated),
        model(stated),
        unit(characteristic_length(stated)),
        all(in_unit_of_length(without_drivers(stated), unit)),
        redundant(held_too_much && all.close()),
        position(blank_position(stated)),
        held_drives(stated.drivers.size()) {
    if (redundant) held = all.poses(unit);
    redundant = redundant && release_here();
    if (!redundant) system = std::make_unique<GroupSystem>(stated);
  }

  bool release_here();
  Status follow(std::span<const Drive> goal, bool statics, int halvings, Position& out);
  bool fits(Status status, const Position& at, double least_grip);
  void hold(std::span<const Drive> goal, const Position& at);
  void find_gap();

  Model given, model;  // as given, and released
  double unit;
  FreeMechanism all;  // its constraints, dependent as they are
  bool redundant;
  std::unique_ptr<GroupSystem> system;
  Position position;       // intermediate position
  std::vector<Pose> held;  // poses of the last position
  std::vector<Drive> held_drives;
  FrictionTaken taken;
  double first_grip = 0.0;
  int releases = 0;
  Gap gap;
  bool opens = false;  // the released mechanism closed, the given one did not
};

/// At the current position. False, and unchanged, if nothing can be released there.
bool ReleasedSystem::Work::release_here() {
  auto next = release(given, held);
  if (!next) return false;
  auto solver = std::make_unique<GroupSystem>(*next);
  if (solver->assemble() != Status::closed) return false;
  model = std::move(*next);
  system = std::move(solver);
  system->take_friction(taken);
  first_grip = grip(model, held);
  ++releases;
  return true;
}

bool ReleasedSystem::Work::fits(Status status, const Position& at, double least_grip) {
  opens = false;
  if (status != Status::closed && status != Status::jams) return false;
  std::vector<double> q;
  for (const Pose& pose : at.pose) q.insert(q.end(), {pose.x / unit, pose.y / unit, pose.phi});
  all.go_to(q);
  const auto residual = all.constraints().residual();
  opens = std::ranges::any_of(residual, [](double r) { return !(std::abs(r) <= closed); });
  return !opens && grip(model, at.pose) >= least_grip;
}

void ReleasedSystem::Work::hold(std::span<const Drive> goal, const Position& at) {
  held = at.pose;
  held_drives.assign(goal.begin(), goal.end());
}

/// To the goal with the current release, else with one chosen at the current position, else half the move first.
Status ReleasedSystem::Work::follow(std::span<const Drive> goal, bool statics, int halvings, Position& out) {
  Status status = system->solve(goal, out, statics);
  if (fits(status, out, enough * first_grip)) {
    hold(goal, out);
    return status;
  }
  if (release_here()) status = system->solve(goal, out, statics);
  const bool last = halvings == 0;
  if (fits(status, out, last ? 0.0 : enough * first_grip)) {
    hold(goal, out);
    return status;
  }
  if (last) return opens ? Status::does_not_close : status;
  std::vector<Drive> middle(goal.begin(), goal.end());
  for (std::size_t k = 0; k < goal.size(); ++k)
    middle[k].coordinate = 0.5 * (held_drives[k].coordinate + goal[k].coordinate);
  if (status = follow(middle, statics, halvings - 1, out); status != Status::closed && status != Status::jams)
    return status;
  return follow(goal, statics, halvings - 1, out);
}

void ReleasedSystem::Work::find_gap() {
  gap = opens ? Gap{} : system->gap();
  if (!opens) return;
  for (std::size_t k = 0; k < all.constraints().pairs().size(); ++k) {
    const double open = unit * all.constraints().opening(k);
    if (open <= gap.size) continue;
    gap.size = open;
    gap.joint = static_cast<int>(k);
  }
}

ReleasedSystem::ReleasedSystem(const Model& model, bool redundant) : work_(std::make_unique<Work>(model, redundant)) {}
ReleasedSystem::~ReleasedSystem() = default;
ReleasedSystem::ReleasedSystem(ReleasedSystem&&) noexcept = default;

Status ReleasedSystem::assemble() {
  Work& w = *work_;
  const Status status = w.system->assemble();
  for (std::size_t k = 0; k < w.held_drives.size(); ++k) w.held_drives[k].coordinate = w.system->coordinate(k);
  return status;
}

double ReleasedSystem::coordinate(std::size_t driver) const { return work_->system->coordinate(driver); }

Status ReleasedSystem::solve(std::span<const Drive> drives, Position& out, bool statics) {
  constexpr int most_halvings = 8;
  Work& w = *work_;
  if (!w.redundant) return w.system->solve(drives, out, statics);
  const Status status = w.follow(drives, statics, most_halvings, w.position);
  if (status == Status::closed || status == Status::jams) {
    out = w.position;
  } else {
    w.find_gap();
  }
  return status;
}

bool ReleasedSystem::followed_in_steps() const { return work_->system->followed_in_steps(); }

void ReleasedSystem::take_friction(FrictionTaken taken) {
  work_->taken = taken;
  work_->system->take_friction(taken);
}

bool ReleasedSystem::some_joint_rests() const { return work_->system->some_joint_rests(); }

void ReleasedSystem::set_load(std::size_t load, Vec force, double moment) {
  for (Model* model : {&work_->given, &work_->model}) {
    model->loads[load].force = force;
    model->loads[load].moment = moment;
  }
  work_->system->set_load(load, force, moment);
}

Gap ReleasedSystem::gap() const { return work_->redundant ? work_->gap : work_->system->gap(); }

const Model& ReleasedSystem::model() const { return work_->model; }
int ReleasedSystem::release_number() const { return work_->releases; }

}  // namespace loadpath::mechanism
