#include "calculators/mechanism/planar_cycle.hpp"

#include "calculators/mechanism/planar_loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace loadpath {

namespace {

using Planar = PlanarMechanism;
using mechanism::Drive;
using mechanism::Status;

bool has_crank(const Planar::Input& in) { return !in.crank.joint.empty(); }

/// The states of all drives at every position.
struct Schedule {
  std::vector<std::vector<Drive>> drives;
  std::vector<double> at;  // of the axis: crank angles, or the first cylinder's places
  double period = 0.0;     // of the crank angle, signed; 0: not a whole turn
};

/// Crank angles as the user counts them.
std::vector<double> crank_angles(const Planar::Crank& crank) {
  std::vector<double> angles;
  for (const auto& place : crank.at) angles.push_back(place.angle);
  if (!angles.empty()) return angles;
  const double sense = in_si(crank.speed) < 0.0 ? -1.0 : 1.0;
  for (int k = 0; k < crank.positions; ++k) angles.push_back(crank.start + sense * 2.0 * pi * k / crank.positions);
  return angles;
}

/// Of angles that differ by whole turns, the one nearest to the assembled position.
double whole_turns(double wanted, double assembled) { return 2.0 * pi * std::round((assembled - wanted) / (2.0 * pi)); }

double place_of(const Planar::Cylinder& c, double assembled, std::size_t k, std::size_t count) {
  const double from = is_set(c.from) ? in_si(c.from) : assembled;
  const double to = is_set(c.to) ? in_si(c.to) : from;
  return count < 2 ? from : from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1);
}

Schedule schedule_of(const Planar::Input& in, const mechanism::GroupSystem& system) {
  Schedule schedule;
  const std::vector<double> angles = has_crank(in) ? crank_angles(in.crank) : std::vector<double>{};
  const std::size_t count = has_crank(in) ? angles.size() : static_cast<std::size_t>(in.positions);
  const double turns = has_crank(in) ? whole_turns(angles[0], system.coordinate(0)) : 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<Drive> drives;
    if (has_crank(in)) drives.push_back({angles[k] + turns, in_si(in.crank.speed), in_si(in.crank.acceleration)});
    for (const Planar::Cylinder& c : in.cylinders) {
      drives.push_back(
          {place_of(c, system.coordinate(drives.size()), k, count), in_si(c.speed), in_si(c.acceleration)});
    }
    schedule.at.push_back(has_crank(in) ? angles[k] : drives.empty() ? 0.0 : drives[0].coordinate);
    schedule.drives.push_back(std::move(drives));
  }
  if (is_whole_turn(in)) schedule.period = in_si(in.crank.speed) < 0.0 ? -2.0 * pi : 2.0 * pi;
  return schedule;
}

void fill_axis(const Schedule& schedule, Axis& axis) {
  axis.at = schedule.at;
  axis.period = schedule.period;
  if (!axis.cyclic()) return;
  axis.share.assign(axis.at.size(), 1.0 / static_cast<double>(axis.at.size()));  // the drive turns evenly
}

/// Whether every effort and reaction is a number: a speed or mass beyond all measure makes none.
bool is_finite(const mechanism::Position& p) {
  return std::all_of(p.effort.begin(), p.effort.end(), [](double e) { return std::isfinite(e); }) &&
         std::all_of(p.reactions.begin(), p.reactions.end(), [](const mechanism::Reaction& r) {
           return std::isfinite(r.force.x) && std::isfinite(r.force.y) && std::isfinite(r.couple);
         });
}

/// The motion stays, forces there are none.
void take_forces_away(mechanism::Position& p) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (double& effort : p.effort) effort = none;
  for (mechanism::Reaction& reaction : p.reactions) reaction = {reaction.at, {none, none}, none};
}

/// What is solved: a mechanism, its drives at every position, with inertia or without.
struct Task {
  const Planar::Input& in;
  mechanism::Model& model;  // its loads as they are at the position
  const Schedule& schedule;
  bool statics;
};

void set_loads(const Task& task, mechanism::GroupSystem& system, double crank_angle) {
  for (std::size_t k = 0; k < task.in.loads.size(); ++k) {
    if (task.in.loads[k].over.empty()) continue;
    const double share = share_at(task.in.loads[k], crank_angle);
    const mechanism::Load full = load_of(task.in, task.in.loads[k]);
    task.model.loads[k].force = share * full.force;
    task.model.loads[k].moment = share * full.moment;
    system.set_load(k, task.model.loads[k].force, task.model.loads[k].moment);
  }
}

void prove(mechanism::Prover& prover, const Task& task, std::span<const Drive> drives, std::size_t k, Cycle& cycle) {
  cycle.proofs[k] = prover.prove(drives, task.statics, cycle.positions[k]);
  const double condition = cycle.proofs[k].condition;
  if (std::isfinite(condition) && condition > cycle.worst_condition) {
    cycle.worst_condition = condition;
    cycle.worst_at = k;
  }
}

/// Solves the positions from the first on, or from the last back, until one does not close; that one is left open.
Status run(mechanism::GroupSystem& system, const Task& task, bool backward, Cycle& cycle) {
  mechanism::Prover prover(task.model);
  const Schedule& schedule = task.schedule;
  const std::size_t count = schedule.drives.size();
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t k = backward ? count - 1 - n : n;
    if (cycle.closed[k]) return Status::closed;
    std::vector<Drive> drives = schedule.drives[k];
    if (backward && schedule.period != 0.0) drives[0].coordinate -= schedule.period;
    if (!drives.empty()) set_loads(task, system, drives[0].coordinate);
    const Status status = system.solve(drives, cycle.positions[k], task.statics);
    if (status != Status::closed && status != Status::jams) return status;
    cycle.jams[k] = status == Status::jams;
    if (cycle.jams[k]) {
      take_forces_away(cycle.positions[k]);
    } else if (is_finite(cycle.positions[k])) {
      prove(prover, task, drives, k, cycle);
    } else {
      return Status::singular;
    }
    cycle.closed[k] = true;
  }
  return Status::closed;
}

}  // namespace

std::string axis_name(const Planar::Input& in) {
  if (has_crank(in)) return in.crank.at.size() == 1 ? "" : "crank angle";
  return in.positions > 1 ? "stroke" : "";
}

double first_crank_angle(const Planar::Crank& crank) { return crank.at.empty() ? crank.start : crank.at[0].angle; }

bool is_whole_turn(const Planar::Input& in) { return has_crank(in) && in.crank.at.empty(); }

Cycle solve_cycle(const Planar::Input& in, const mechanism::Model& model, Axis* axis) {
  mechanism::GroupSystem system(model);
  Cycle cycle;
  cycle.first_failure = system.assemble();
  const Schedule schedule = schedule_of(in, system);
  if (axis != nullptr) fill_axis(schedule, *axis);
  cycle.positions.assign(schedule.drives.size(), mechanism::blank_position(model));
  cycle.proofs.assign(schedule.drives.size(), {});
  cycle.closed.assign(schedule.drives.size(), false);
  cycle.jams = cycle.closed;
  if (cycle.first_failure != Status::closed) {
    cycle.gap = system.gap();
    return cycle;
  }
  mechanism::Model now = model;
  const Task task{in, now, schedule, in.analysis == Planar::Analysis::statics};
  cycle.first_failure = run(system, task, false, cycle);
  if (cycle.first_failure == Status::closed) return cycle;
  cycle.gap = system.gap();
  mechanism::GroupSystem again(model);  // what closes on the other side of the gap is reached backwards from the start
  if (again.assemble() == Status::closed) run(again, task, true, cycle);
  return cycle;
}

}  // namespace loadpath
