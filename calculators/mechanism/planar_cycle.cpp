#include "calculators/mechanism/planar_cycle.hpp"

#include "calculators/mechanism/planar_loads.hpp"
#include "lib/numerics/spline.hpp"

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
  std::vector<double> at;  // of the axis: crank angles, or the first cylinder's places, or times
  double turns = 0.0;      // by which the drive's coordinate is ahead of the crank angle, rad
  double period = 0.0;     // of the crank angle, signed; 0: not a whole turn
};

/// Crank angles as the user counts them.
std::vector<double> crank_angles(const Planar::Crank& crank) {
  std::vector<double> angles;
  for (const auto& place : crank.at) angles.push_back(place.angle);
  if (!angles.empty()) return angles;
  const double sense = in_si(crank.speed) < 0.0 ? -1.0 : 1.0;
  const double cycle = sense * 2.0 * pi * crank.turns;
  for (int k = 0; k < crank.positions; ++k) angles.push_back(crank.start + cycle * k / crank.positions);
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
  schedule.turns = turns;
  if (is_whole_turn(in)) schedule.period = (in_si(in.crank.speed) < 0.0 ? -2.0 : 2.0) * pi * in.crank.turns;
  return schedule;
}

/// A law of motion, given at some moments.
struct Law {
  std::vector<double> t, place;

  explicit Law(const Planar::Crank& crank) {
    for (const auto& moment : crank.law) add(moment.t, moment.angle);
  }
  explicit Law(const Planar::Cylinder& cylinder) {
    for (const auto& moment : cylinder.law) add(moment.t, in_si(moment.place));
  }
  void add(Time at, double there) {
    t.push_back(in_si(at));
    place.push_back(there);
  }
};

/// A drive without a law of its own goes on from where it stands, with its speed and acceleration.
Drive drive_at(const Law& law, const Drive& start, double since, double t) {
  if (law.t.empty()) {
    const double after = t - since, speed = start.speed + start.acceleration * after;
    return {start.coordinate + 0.5 * (start.speed + speed) * after, speed, start.acceleration};
  }
  const RestToRestSpline::Value value = RestToRestSpline(law.t, law.place).at(t);
  return {value.y, value.first, value.second};
}

/// Equal steps of time, from the first moment of a law to the last of one.
Schedule schedule_by_law(const Planar::Input& in, const mechanism::GroupSystem& system) {
  std::vector<Law> laws;
  std::vector<Drive> starts;
  double ahead = 0.0;
  if (has_crank(in)) {
    laws.emplace_back(in.crank);
    const double start = in.crank.law.empty() ? in.crank.start : in.crank.law[0].angle;
    const double turns = whole_turns(start, system.coordinate(0));
    for (double& angle : laws.back().place) angle += turns;
    ahead = turns;
    starts.push_back({start + turns, in_si(in.crank.speed), in_si(in.crank.acceleration)});
  }
  for (const Planar::Cylinder& c : in.cylinders) {
    laws.emplace_back(c);
    const double from = is_set(c.from) ? in_si(c.from) : system.coordinate(starts.size());
    starts.push_back({from, in_si(c.speed), in_si(c.acceleration)});
  }
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const Law& law : laws) {
    if (law.t.empty()) continue;
    first = std::min(first, law.t.front());
    last = std::max(last, law.t.back());
  }
  Schedule schedule;
  schedule.turns = ahead;
  const int count = has_crank(in) ? in.crank.positions : in.positions;
  for (int k = 0; k < count; ++k) {
    const double t = count > 1 ? first + (last - first) * k / (count - 1) : first;
    schedule.at.push_back(t);
    schedule.drives.emplace_back();
    for (std::size_t d = 0; d < laws.size(); ++d)
      schedule.drives.back().push_back(drive_at(laws[d], starts[d], first, t));
  }
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
    const double share = share_at(task.in.loads[k], crank_angle, 2.0 * pi * task.in.crank.turns);
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
    if (!drives.empty()) set_loads(task, system, drives[0].coordinate - schedule.turns);
    const Status status = system.solve(drives, cycle.positions[k], task.statics);
    if (status != Status::closed && status != Status::jams) return status;
    cycle.drives[k] = drives;
    cycle.jams[k] = status == Status::jams;
    cycle.in_steps[k] = n > 0 && system.followed_in_steps();
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

/// Whether every link is where it was once the cycle is over, but for whole turns.
bool returns(mechanism::GroupSystem& system, const Task& task, const mechanism::Position& first) {
  constexpr double tolerance = 1e-6;
  std::vector<Drive> drives = task.schedule.drives.front();
  drives[0].coordinate += task.schedule.period;
  mechanism::Position after = mechanism::blank_position(task.model);
  const Status status = system.solve(drives, after, task.statics);
  if (status != Status::closed && status != Status::jams) return false;
  for (std::size_t k = 0; k < after.pose.size(); ++k) {
    const mechanism::Pose &a = first.pose[k], &b = after.pose[k];
    if (std::abs(std::remainder(b.phi - a.phi, 2.0 * pi)) > tolerance) return false;
    if (std::hypot(b.x - a.x, b.y - a.y) > tolerance * (1.0 + std::hypot(a.x, a.y))) return false;
  }
  return true;
}

}  // namespace

std::string axis_name(const Planar::Input& in) {
  if (has_law(in)) return "time";
  if (has_crank(in)) return in.crank.at.size() == 1 ? "" : "crank angle";
  return in.positions > 1 ? "stroke" : "";
}

double first_crank_angle(const Planar::Crank& crank) { return crank.at.empty() ? crank.start : crank.at[0].angle; }

bool is_whole_turn(const Planar::Input& in) { return has_crank(in) && in.crank.at.empty() && !has_law(in); }

bool has_law(const Planar::Input& in) {
  return !in.crank.law.empty() ||
         std::any_of(in.cylinders.begin(), in.cylinders.end(), [](const auto& c) { return !c.law.empty(); });
}

/// Moments that do not follow one another. Needs values.
template <class Drive>
static void check_law(const Drive& drive, const std::string& path, std::vector<FieldFault>& faults) {
  if (drive.law.size() == 1)
    faults.push_back(
        {path, say("a law of motion has two moments or more"), say("write law = [[\"0 s\", ...], [\"1 s\", ...]]")});
  for (std::size_t k = 1; k < drive.law.size(); ++k) {
    if (drive.law[k].t > drive.law[k - 1].t) continue;
    faults.push_back({path, say("the times of a law must rise from each to the next"), {}});
    return;
  }
}

std::vector<FieldFault> check_laws(const Planar::Input& in) {
  std::vector<FieldFault> faults;
  check_law(in.crank, "crank.law", faults);
  for (const auto& c : in.cylinders) check_law(c, "cylinders." + std::string(c.name.view()) + ".law", faults);
  return faults;
}

Cycle solve_cycle(const Planar::Input& in, const mechanism::Model& model, Axis* axis) {
  mechanism::GroupSystem system(model);
  Cycle cycle;
  cycle.first_failure = system.assemble();
  const Schedule schedule = has_law(in) ? schedule_by_law(in, system) : schedule_of(in, system);
  if (axis != nullptr) fill_axis(schedule, *axis);
  cycle.positions.assign(schedule.drives.size(), mechanism::blank_position(model));
  cycle.proofs.assign(schedule.drives.size(), {});
  cycle.drives = schedule.drives;
  cycle.closed.assign(schedule.drives.size(), false);
  cycle.jams = cycle.in_steps = cycle.closed;
  if (cycle.first_failure != Status::closed) {
    cycle.gap = system.gap();
    return cycle;
  }
  mechanism::Model now = model;
  const Task task{in, now, schedule, in.analysis == Planar::Analysis::statics};
  cycle.first_failure = run(system, task, false, cycle);
  if (cycle.first_failure == Status::closed) {
    cycle.returns = schedule.period == 0.0 || returns(system, task, cycle.positions[0]);
    return cycle;
  }
  cycle.gap = system.gap();
  mechanism::GroupSystem again(model);  // what closes on the other side of the gap is reached backwards from the start
  if (again.assemble() == Status::closed) run(again, task, true, cycle);
  return cycle;
}

}  // namespace loadpath
