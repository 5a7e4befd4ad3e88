#include "calculators/mechanism/cycle/cycle.hpp"

#include "calculators/mechanism/cycle/either_way.hpp"
#include "calculators/mechanism/cycle/equilibria.hpp"
#include "calculators/mechanism/cycle/schedule.hpp"
#include "calculators/mechanism/input/law.hpp"
#include "lib/mechanism/model/spring.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace loadpath::planar {

namespace {

using mechanism::Drive;
using mechanism::Status;

// Smaller differences count as returned, rad or parts of its size.
constexpr double returning = 1e-6;

/// Whether every effort and reaction is a number: a speed or mass beyond all measure makes none.
bool is_finite(const mechanism::Position& p) {
  return std::all_of(p.effort.begin(), p.effort.end(), [](double e) { return std::isfinite(e); }) &&
         std::all_of(p.reactions.begin(), p.reactions.end(), [](const mechanism::Reaction& r) {
           return std::isfinite(r.force.x) && std::isfinite(r.force.y) && std::isfinite(r.couple);
         });
}

/// The motion stays, forces there are none.
void take_forces_away(mechanism::Position& p) {
  for (double& effort : p.effort) effort = none;
  for (mechanism::Reaction& reaction : p.reactions) reaction = {reaction.at, {none, none}, none};
}

void prove(mechanism::Prover& prover, const CycleTask& task, std::span<const Drive> drives, std::size_t k,
           Cycle& cycle) {
  cycle.proofs[k] = prover.prove(drives, task.statics, cycle.positions[k]);
  const double condition = cycle.proofs[k].condition;
  if (!std::isfinite(condition)) return;
  if (numerics::exceeds(condition, cycle.worst_condition)) cycle.worst_at = k;
  cycle.worst_condition = std::max(cycle.worst_condition, condition);
}

/// Solves the positions from the first on, or from the last back, until one does not close; that one is left open.
Status run(mechanism::ReleasedSystem& system, const CycleTask& task, bool backward, Cycle& cycle) {
  std::optional<mechanism::Prover> prover;
  int proves = -1;  // which release
  const Schedule& schedule = task.schedule;
  const std::size_t count = schedule.drives.size();
  std::optional<std::size_t> passing;  // a change point, until the position after it is reached
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t k = backward ? count - 1 - n : n;
    if (cycle.closed[k]) return Status::closed;
    std::vector<Drive> drives = schedule.drives[k];
    if (backward && schedule.period != 0.0) drives[0].coordinate -= schedule.period;
    set_loads(task, system, drives, k, cycle.positions[k]);
    const Status status = system.solve(drives, cycle.positions[k], task.statics);
    if (status == Status::singular && !passing) {
      passing = k;
      cycle.at_change_point[k] = true;
      continue;
    }
    if (status != Status::closed && status != Status::jams) {
      if (passing) cycle.at_change_point[*passing] = false;
      return status;
    }
    passing.reset();
    cycle.drives[k] = drives;
    cycle.undirected[k] = mechanism::some_spring_has_no_direction(task.model, cycle.positions[k]);
    cycle.jams[k] = !cycle.undirected[k] && status == Status::jams;
    cycle.in_steps[k] = n > 0 && system.followed_in_steps();
    cycle.some_rest[k] = system.some_joint_rests();
    if (cycle.jams[k] || cycle.undirected[k]) {
      take_forces_away(cycle.positions[k]);
    } else if (is_finite(cycle.positions[k])) {
      if (proves != system.release_number()) prover.emplace(system.model());
      proves = system.release_number();
      prove(*prover, task, drives, k, cycle);
    } else {
      return Status::singular;
    }
    cycle.closed[k] = true;
  }
  return Status::closed;
}

/// The turning springs that the cycle winds up.
std::vector<Cycle::Winding> windings_of(const mechanism::Model& model, const mechanism::Position& first,
                                        const mechanism::Position& after) {
  const auto turned = [&](int link) {
    const auto k = static_cast<std::size_t>(link);
    return link == mechanism::ground ? 0.0 : after.pose[k].phi - first.pose[k].phi;
  };
  std::vector<Cycle::Winding> windings;
  for (std::size_t n = 0; n < model.springs.size(); ++n) {
    const mechanism::Spring& spring = model.springs[n];
    const double by = turned(spring.i) - turned(spring.j);
    const bool turns = spring.kind == mechanism::Spring::Kind::turning && spring.rate > 0.0;
    if (turns && std::abs(by) > returning) windings.push_back({n, by});
  }
  return windings;
}

/// Whether every link returns to its start at the end of the cycle, but for full revolutions.
bool returns(mechanism::ReleasedSystem& system, const CycleTask& task, Cycle& cycle) {
  const mechanism::Position& first = cycle.positions[0];
  std::vector<Drive> drives = task.schedule.drives.front();
  drives[0].coordinate += task.schedule.period;
  mechanism::Position after = mechanism::blank_position(task.model);
  const Status status = system.solve(drives, after, task.statics);
  if (status != Status::closed && status != Status::jams) return false;
  cycle.windings = windings_of(task.model, first, after);
  for (std::size_t k = 0; k < after.pose.size(); ++k) {
    const mechanism::Pose &a = first.pose[k], &b = after.pose[k];
    if (std::abs(std::remainder(b.phi - a.phi, 2.0 * pi)) > returning) return false;
    if (std::hypot(b.x - a.x, b.y - a.y) > returning * (1.0 + std::hypot(a.x, a.y))) return false;
  }
  return true;
}

/// The positions where nothing need hold it take the place of those that were asked for.
void stay_in_equilibrium(const Mechanism::Input& in, const mechanism::Model& model, bool redundant,
                         const Assembled& assembled, Cycle& cycle) {
  cycle.equilibria = equilibria_of(in, model, redundant, cycle.between.places, assembled);
  cycle.between = {};
  for (const Equilibrium& e : cycle.equilibria.found) cycle.between.places.push_back(e.place);
}

}  // namespace

std::string axis_name(const Mechanism::Input& in) {
  if (has_law(in)) return "time";
  if (has_crank(in)) return in.crank.at.size() == 1 ? "" : "crank angle";
  return in.positions > 1 ? "stroke" : "";
}

std::string axis_symbol(const Axis& axis) {
  if (axis.quantity == "time") return "t";
  return axis.quantity == "stroke" ? "s" : "phi";
}

double first_crank_angle(const planar::Crank& crank) { return crank.at.empty() ? crank.start : crank.at[0].angle; }

Cycle solve_cycle(const Mechanism::Input& in, const mechanism::Model& model, bool redundant, Axis* axis) {
  mechanism::ReleasedSystem system(model, redundant);
  Cycle cycle;
  cycle.first_failure = system.assemble();
  const Assembled assembled = [&](std::size_t driver) { return system.coordinate(driver); };
  const bool stands = cycle.first_failure == Status::closed;
  if (stands) cycle.between = places_between(in, model, redundant, assembled);
  if (stands && stays_in_equilibrium(in)) stay_in_equilibrium(in, model, redundant, assembled, cycle);
  Schedule schedule = stands ? schedule_of(in, assembled, cycle.between.places) : schedule_of(in, assembled);
  schedule.is_uneven = cycle.between.inserted > 0;
  if (axis != nullptr) fill_axis(schedule, *axis);
  cycle.positions.assign(schedule.drives.size(), mechanism::blank_position(model));
  cycle.proofs.assign(schedule.drives.size(), {});
  cycle.drives = schedule.drives;
  cycle.closed.assign(schedule.drives.size(), false);
  cycle.at_change_point = cycle.jams = cycle.undirected = cycle.in_steps = cycle.some_rest = cycle.closed;
  if (cycle.first_failure != Status::closed) {
    cycle.gap = system.gap();
    return cycle;
  }
  if (redundant) cycle.unique = mechanism::uniqueness(model);
  const LoadCourses courses(in);
  const CycleTask task{in, model, redundant, schedule, leaves_out_inertia(in), courses};
  cycle.first_failure = run(system, task, false, cycle);
  if (cycle.first_failure == Status::closed) {
    cycle.returns = schedule.period == 0.0 || !cycle.closed[0] || returns(system, task, cycle);
  } else {
    cycle.gap = system.gap();
    mechanism::ReleasedSystem again(model,
                                    redundant);  // positions beyond the gap are reached backwards from the start
    if (again.assemble() == Status::closed) run(again, task, true, cycle);
  }
  solve_either_way(task, cycle);
  return cycle;
}

}  // namespace loadpath::planar
