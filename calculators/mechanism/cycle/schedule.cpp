#include "calculators/mechanism/cycle/schedule.hpp"

#include "calculators/mechanism/input/law.hpp"
#include "calculators/mechanism/input/loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace loadpath::planar {

namespace {

using mechanism::Drive;

/// The crank angle at a place among the positions, as the user counts it; between two of them too.
double crank_angle_at(const planar::Crank& crank, double k) {
  if (!crank.at.empty()) {
    const auto before = std::min(static_cast<std::size_t>(k), crank.at.size() - 1);
    const double past = k - static_cast<double>(before), angle = crank.at[before].angle;
    return past > 0.0 && before + 1 < crank.at.size() ? angle + past * (crank.at[before + 1].angle - angle) : angle;
  }
  const double cycle = turning_sense(crank) * 2.0 * pi * crank.turns;
  return crank.start + cycle * k / crank.positions;
}

/// As many places as there are positions.
std::vector<double> evenly(std::size_t count) {
  std::vector<double> places(count);
  std::iota(places.begin(), places.end(), 0.0);
  return places;
}

/// The full revolutions that bring an angle nearest to the assembled position.
double whole_turns(double wanted, double assembled) { return 2.0 * pi * std::round((assembled - wanted) / (2.0 * pi)); }

double place_of(const planar::Cylinder& c, double assembled, double k, std::size_t count) {
  const double from = is_set(c.from) ? in_si(c.from) : assembled;
  const double to = is_set(c.to) ? in_si(c.to) : from;
  return count < 2 ? from : from + (to - from) * k / static_cast<double>(count - 1);
}

double sense_of(planar::Impending impending) {
  return impending == planar::Impending::either ? 0.0 : impending == planar::Impending::forward ? 1.0 : -1.0;
}

Schedule schedule_by_speeds(const Mechanism::Input& in, const Assembled& assembled, const std::vector<double>& places) {
  Schedule schedule;
  const std::size_t count = positions_of(in);
  const double turns = has_crank(in) ? whole_turns(crank_angle_at(in.crank, 0.0), assembled(0)) : 0.0;
  for (const double k : places) {
    std::vector<Drive> drives;
    const double angle = has_crank(in) ? crank_angle_at(in.crank, k) : 0.0;
    if (has_crank(in)) drives.push_back(drive_of(in.crank, angle + turns));
    for (const planar::Cylinder& c : in.cylinders) {
      drives.push_back({place_of(c, assembled(drives.size()), k, count), in_si(c.speed), in_si(c.acceleration),
                        sense_of(c.impending)});
    }
    schedule.at.push_back(has_crank(in) ? angle : drives.empty() ? 0.0 : drives[0].coordinate);
    schedule.drives.push_back(std::move(drives));
  }
  schedule.turns = turns;
  if (is_whole_turn(in)) schedule.period = turning_sense(in.crank) * 2.0 * pi * in.crank.turns;
  return schedule;
}

/// A drive without a law of its own continues from its position, with its speed and acceleration.
Drive drive_at(const DriveLaw& law, const Drive& start, double since, double t) {
  if (law.empty()) {
    const double after = t - since, speed = start.speed + start.acceleration * after;
    return {start.coordinate + 0.5 * (start.speed + speed) * after, speed, start.acceleration};
  }
  const numerics::Jet there = law.at(t);
  return {there.value, there.first, there.second};
}

/// Where a law turns round, rounding leaves a speed of either sign: the drive rests there.
void let_rest(Schedule& schedule) {
  constexpr double rounding = 1e-9;  // share of its largest speed
  for (std::size_t d = 0; !schedule.drives.empty() && d < schedule.drives.front().size(); ++d) {
    double most = 0.0;
    for (const auto& drives : schedule.drives) most = std::max(most, std::abs(drives[d].speed));
    for (auto& drives : schedule.drives) {
      if (std::abs(drives[d].speed) <= rounding * most) drives[d].speed = 0.0;
    }
  }
}

/// Equal steps of time, from the first moment of a law to the last of one.
Schedule schedule_by_laws(const Mechanism::Input& in, const Assembled& assembled, const std::vector<double>& places) {
  std::vector<DriveLaw> laws;
  std::vector<Drive> starts;
  if (has_crank(in)) {
    laws.emplace_back(in.crank);
    starts.push_back({in.crank.start, in_si(in.crank.speed), in_si(in.crank.acceleration)});
  }
  for (const planar::Cylinder& c : in.cylinders) {
    laws.emplace_back(c);
    const double from = is_set(c.from) ? in_si(c.from) : assembled(starts.size());
    starts.push_back({from, in_si(c.speed), in_si(c.acceleration)});
  }
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const DriveLaw& law : laws) {
    if (law.empty()) continue;
    first = std::min(first, law.first());
    last = std::max(last, law.last());
  }
  Schedule schedule;
  if (has_crank(in)) schedule.turns = whole_turns(drive_at(laws[0], starts[0], first, first).coordinate, assembled(0));
  const std::size_t count = positions_of(in);
  for (const double k : places) {
    const double t = count > 1 ? first + (last - first) * k / static_cast<double>(count - 1) : first;
    schedule.at.push_back(t);
    schedule.drives.emplace_back();
    std::vector<Drive>& drives = schedule.drives.back();
    for (std::size_t d = 0; d < laws.size(); ++d) drives.push_back(drive_at(laws[d], starts[d], first, t));
    if (has_crank(in)) drives[0].coordinate += schedule.turns;
  }
  let_rest(schedule);
  return schedule;
}

}  // namespace

bool has_crank(const Mechanism::Input& in) { return !in.crank.joint.empty(); }

bool is_whole_turn(const Mechanism::Input& in) {
  return has_crank(in) && in.crank.at.empty() && !has_law(in) && !stays_in_equilibrium(in);
}

double turning_sense(const planar::Crank& crank) { return in_si(crank.speed) < 0.0 ? -1.0 : 1.0; }

Drive drive_of(const planar::Crank& crank, double coordinate) {
  return {coordinate, in_si(crank.speed), in_si(crank.acceleration), sense_of(crank.impending)};
}

std::size_t positions_of(const Mechanism::Input& in) {
  if (!has_crank(in)) return static_cast<std::size_t>(in.positions);
  return in.crank.at.empty() || has_law(in) ? static_cast<std::size_t>(in.crank.positions) : in.crank.at.size();
}

Schedule schedule_of(const Mechanism::Input& in, const Assembled& assembled) {
  return schedule_of(in, assembled, evenly(positions_of(in)));
}

Schedule schedule_of(const Mechanism::Input& in, const Assembled& assembled, const std::vector<double>& places) {
  return has_law(in) ? schedule_by_laws(in, assembled, places) : schedule_by_speeds(in, assembled, places);
}

void fill_axis(const Schedule& schedule, Axis& axis) {
  axis.at = schedule.at;
  axis.period = schedule.period;
  if (!axis.cyclic()) return;
  const std::size_t count = axis.at.size();
  axis.share.assign(count, 1.0 / static_cast<double>(count));  // the drive turns evenly
  if (!schedule.is_uneven) return;
  for (std::size_t k = 0; k < count; ++k) {
    const double before = k == 0 ? axis.at[count - 1] - axis.period : axis.at[k - 1];
    const double after = k + 1 == count ? axis.at[0] + axis.period : axis.at[k + 1];
    axis.share[k] = 0.5 * (after - before) / axis.period;
  }
}

void set_loads(const CycleTask& task, mechanism::ReleasedSystem& system, const std::vector<Drive>& drives,
               std::size_t k, mechanism::Position& place) {
  if (task.courses.by_stroke()) (void)system.solve(drives, place, task.statics);  // the next solution reports a failure
  const double crank_angle = drives.empty() ? 0.0 : drives[0].coordinate - task.schedule.turns;
  const Instant now{crank_angle, time_at(task.in, task.schedule.at, k), place};
  for (std::size_t n = 0; n < task.in.loads.size(); ++n) {
    const planar::Load& load = task.in.loads[n];
    const CourseNow* const course = task.courses.of(n);
    if (load.over.empty() && course == nullptr) continue;
    const double share = course != nullptr ? course->share(course->argument(now, task.model))
                                           : share_at(load, crank_angle, 2.0 * pi * task.in.crank.turns);
    system.set_load(n, share * task.model.loads[n].force, share * task.model.loads[n].moment);
  }
}

}  // namespace loadpath::planar
