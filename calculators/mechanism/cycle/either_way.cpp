#include "calculators/mechanism/cycle/either_way.hpp"

#include "calculators/mechanism/input/law.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

using mechanism::Drive;
using mechanism::Position;
using mechanism::ReleasedSystem;
using mechanism::Resting;
using mechanism::Status;

class EitherWay {
 public:
  EitherWay(const CycleTask& task, Cycle& cycle)
      : task_(task), cycle_(cycle), position_(mechanism::blank_position(task.model)) {}

  void run() {
    const std::size_t count = cycle_.positions.size();
    cycle_.either_way.resize(count);
    if (task_.model.drivers.size() == 1) cycle_.standing.resize(count);
    std::vector<bool> done(count);
    for (const bool backward : {false, true}) {
      ReleasedSystem system(task_.model, task_.redundant);
      if (system.assemble() != Status::closed) return;
      for (std::size_t n = 0; n < count; ++n) {
        const std::size_t k = backward ? count - 1 - n : n;
        if (!cycle_.closed[k] || done[k]) break;
        solve(system, k, backward);
        done[k] = true;
      }
    }
    if (!all_stand_) cycle_.stands_everywhere.reset();
  }

 private:
  void solve(ReleasedSystem& system, std::size_t k, bool backward) {
    std::vector<Drive> drives = task_.schedule.drives[k];
    if (backward && task_.schedule.period != 0.0) drives[0].coordinate -= task_.schedule.period;
    set_loads(task_, system, drives, k, position_);
    if (cycle_.undirected[k]) return;
    if (cycle_.some_rest[k]) {
      if (mechanism::moves(drives)) {
        add_sides(system, drives, k);
      } else {
        add_ways(system, drives, k);
      }
    }
    if (cycle_.standing.empty()) return;
    Drive& drive = drives[0];
    drive.speed = drive.acceleration = 0.0;
    StandingEffort& standing = cycle_.standing[k];
    standing = {effort(system, drives, -1.0), effort(system, drives, 0.0), effort(system, drives, 1.0)};
    standing.known = std::isfinite(standing.without);
    if (standing.known) find_thresholds(system, drives, k);
  }

  /// Joints rest while others move.
  void add_sides(ReleasedSystem& system, const std::vector<Drive>& drives, std::size_t k) {
    for (const Resting side : {Resting::as_before, Resting::as_after}) {
      system.take_friction({side, 1.0});
      add(system, drives, k);
    }
    system.take_friction({});
  }

  /// All at rest: motion of every drive may be impending in either direction, unless its direction is given.
  void add_ways(ReleasedSystem& system, std::vector<Drive> drives, std::size_t k) {
    std::vector<Drive*> open;
    for (Drive& drive : drives) {
      if (drive.impending == 0.0) open.push_back(&drive);
    }
    for (std::size_t way = 0; way < (std::size_t{1} << open.size()); ++way) {
      for (std::size_t d = 0; d < open.size(); ++d) open[d]->impending = (way >> d) % 2 == 1 ? 1.0 : -1.0;
      add(system, drives, k);
    }
  }

  void add(ReleasedSystem& system, const std::vector<Drive>& drives, std::size_t k) {
    const Status status = system.solve(drives, position_, task_.statics);
    cycle_.either_way[k].push_back(status == Status::closed ? position_ : Position{});
  }

  /// That starts it so from rest, with a part of its friction.
  double effort(ReleasedSystem& system, std::vector<Drive>& drives, double impending, double share = 1.0) {
    drives[0].impending = impending;
    system.take_friction({Resting::without_friction, share});
    const Status status = system.solve(drives, position_, true);
    system.take_friction({});
    return status == Status::closed ? position_.effort[0] : none;
  }

  /// The effort against the load falls with friction; where it is zero, the mechanism stays at rest.
  void find_thresholds(ReleasedSystem& system, std::vector<Drive>& drives, std::size_t k) {
    const StandingEffort& standing = cycle_.standing[k];
    all_stand_ = all_stand_ && standing.stands();
    if (!standing.stands() || !is_loaded(standing)) return;
    const double sense = standing.without > 0.0 ? 1.0 : -1.0;
    const auto stands = [&](double share) { return !(sense * effort(system, drives, -sense, share) > 0.0); };
    const auto least = [&](double low, double high) {
      while (high - low > 1e-9) {
        const double middle = 0.5 * (low + high);
        (stands(middle) ? high : low) = middle;
      }
      return Cycle::Threshold{high, k};
    };
    constexpr double nearly = 1.0 - 1e-6;
    auto &somewhere = cycle_.stands_somewhere, &everywhere = cycle_.stands_everywhere;
    const double first = somewhere ? somewhere->share : 1.0, last = everywhere ? everywhere->share : 0.0;
    if (!somewhere || stands(nearly * first)) somewhere = least(0.0, first);
    if (!everywhere || (all_stand_ && !stands(last))) everywhere = least(last, 1.0);
  }

  /// Without a load it stays at rest anyway.
  static bool is_loaded(const StandingEffort& standing) {
    const double friction = std::max(std::abs(standing.forward - standing.without), std::abs(standing.without));
    return standing.without != 0.0 && !(std::abs(standing.without) < 1e-9 * friction);
  }

  const CycleTask& task_;
  Cycle& cycle_;
  Position position_;
  bool all_stand_ = true;
};

}  // namespace

bool has_dry_friction(const mechanism::Model& model) {
  return std::any_of(model.joints.begin(), model.joints.end(),
                     [](const mechanism::Joint& joint) { return joint.friction.dry(); });
}

std::vector<FieldFault> check_rest(const Mechanism::Input& in, const mechanism::Model& model) {
  constexpr int most = 4;  // drives with both directions tried
  const auto rests = [](const auto& drive) { return in_si(drive.speed) == 0.0; };
  const auto is_open = [](const auto& drive) { return drive.impending == planar::Impending::either; };
  const bool all_rest = rests(in.crank) && std::all_of(in.cylinders.begin(), in.cylinders.end(), rests);
  const auto cylinders = std::count_if(in.cylinders.begin(), in.cylinders.end(), is_open);
  const auto open = cylinders + (has_crank(in) && is_open(in.crank) ? 1 : 0);
  if (has_law(in) || !all_rest || open <= most || !has_dry_friction(model)) return {};
  return {
      {"cylinders",
       say("friction with {1} drives at rest is not covered: each may start in either direction", std::to_string(open)),
       say("state 'impending' of all but {1}, or give them their speeds", std::to_string(most))}};
}

void solve_either_way(const CycleTask& task, Cycle& cycle) {
  if (has_dry_friction(task.model) && !task.model.drivers.empty()) EitherWay(task, cycle).run();
}

}  // namespace loadpath::planar
