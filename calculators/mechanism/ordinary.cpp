#include "calculators/mechanism/ordinary.hpp"

#include "calculators/mechanism/aspects.hpp"
#include "calculators/mechanism/results/values.hpp"
#include "lib/mechanism/columns/cycle.hpp"
#include "lib/mechanism/columns/largest.hpp"
#include "lib/mechanism/proof/proof.hpp"
#include "lib/sweep/statistics/lanes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::planar {

namespace {

using account::State;
using Verdicts = std::vector<account::Verdict>;

constexpr mechanism::Kept everything{
    .forces = true, .poses = true, .velocities = true, .accelerations = true, .pins = true};
// For results from forces only: data for the size of rounding, and the subset that is read.
constexpr mechanism::Kept sizes{
    .forces = true, .poses = true, .angles = false, .velocities = true, .accelerations = true};
constexpr mechanism::Kept forces{.forces = true, .velocities = true};
// Positions that are read at once: few enough for the fastest cache.
constexpr std::size_t block = 16;

/// As of its positions, of a mechanism with one rotary drive whose loads stay as they are.
Magnitudes magnitudes_of(const mechanism::Model& model, const mechanism::CycleColumns& columns, double force) {
  Magnitudes of{.force = force};
  const auto raise = [](std::span<const double> x, double& most) { most = std::max(most, mechanism::largest_size(x)); };
  const auto raise_square = [](std::span<const double> x, std::span<const double> y, double& most) {
    most = std::max(most, mechanism::largest_square(x, y));
  };
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    raise_square(columns.pose(k).x, columns.pose(k).y, of.length);
    raise_square(columns.velocity(k).x, columns.velocity(k).y, of.speed);
    raise_square(columns.acceleration(k).x, columns.acceleration(k).y, of.acceleration);
    raise(columns.velocity(k).phi, of.turning);
    raise(columns.acceleration(k).phi, of.angular_acceleration);
  }
  for (std::size_t j = 0; j < model.joints.size(); ++j) raise(columns.couple(j), of.couple);
  for (const mechanism::Load& load : model.loads) {
    raise_square({&load.force.x, 1}, {&load.force.y, 1}, of.force);
    raise({&load.moment, 1}, of.couple);
  }
  raise(columns.effort(0), of.couple);
  return of;
}

/// Whether the drive and the loads are of the ordinary kind.
bool is_plain(const Solved& solved) {
  const Mechanism::Input& in = solved.in;
  const LoadCourses courses(in);
  const bool loads_stay = std::all_of(in.loads.begin(), in.loads.end(), [&](const auto& load) {
    return load.over.empty() && courses.of(static_cast<std::size_t>(&load - &*in.loads.begin())) == nullptr;
  });
  const bool even = solved.proved.between.inserted == 0 && solved.proved.between.missed.empty();
  return even && !has_short_segments(in) && has_crank(in) && in.cylinders.empty() && !has_law(in) &&
         solved.axis != nullptr && loads_stay && solved.structure.redundant.empty() && in.sides.empty() &&
         solved.given.drivers.size() == 1 && solved.given.drivers[0].kind == mechanism::Driver::Kind::rotary &&
         solved.cycle.closed.size() > 1;
}

/// Verdicts that hold wherever a chain keeps clear of its change points: it closes, keeps its assembly, and is proved.
constexpr std::array settled{&aspects::closing, &aspects::equations, &aspects::changes_of_assembly};

/// An aspect whose verdicts depend on numbers.
bool depends_on_numbers(const Aspect& aspect) {
  return aspect.judge != nullptr && aspect.find == nullptr && std::ranges::find(settled, &aspect) == settled.end();
}

Verdicts verdicts_of_numbers(const Solved& solved) {
  Verdicts verdicts;
  for (const Aspect* aspect : all_aspects()) {
    if (depends_on_numbers(*aspect)) aspect->judge(solved, verdicts);
  }
  return verdicts;
}

Verdicts settled_of(const Solved& solved) {
  Verdicts verdicts;
  for (const Aspect* const aspect : settled) aspect->judge(solved, verdicts);
  return verdicts;
}

bool all_pass(const Verdicts& verdicts) {
  return std::all_of(verdicts.begin(), verdicts.end(), [](const auto& v) { return v.state == State::pass; });
}

bool are_alike(const Verdicts& one, const Verdicts& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const auto& a, const auto& b) { return a.symbol == b.symbol && a.state == b.state; });
}

std::vector<bool> heavy_links(const mechanism::Model& model) {
  std::vector<bool> heavy;
  for (const mechanism::Link& link : model.links) {
    heavy.push_back(link.mass > 0.0);
    heavy.push_back(link.inertia > 0.0);
  }
  return heavy;
}

/// An aspect with requested results.
struct Wanted {
  const Aspect* aspect;
  std::vector<std::string> paths;
  bool follow_from_positions = true;  // from nothing else
};

/// The requested outputs of an aspect.
std::vector<Output> outputs_of(const Wanted& wanted, const Mechanism::Input& in, const mechanism::Model& model) {
  std::vector<Output> outputs;
  wanted.aspect->add_outputs(in, model, outputs);
  std::erase_if(outputs, [&](const Output& output) {
    return std::find(wanted.paths.begin(), wanted.paths.end(), output.path) == wanted.paths.end();
  });
  return outputs;
}

/// None if a requested result is not read off positions: an input, a size of the full cycle.
std::optional<std::vector<Wanted>> wanted_of(const Solved& solved, const std::set<std::string>& asked) {
  std::vector<Wanted> all;
  std::size_t found = 0;
  for (const Aspect* aspect : all_aspects()) {
    if (aspect->add_outputs == nullptr) continue;
    std::vector<Output> outputs;
    aspect->add_outputs(solved.in, solved.model, outputs);
    Wanted own{aspect, {}};
    for (const Output& output : outputs) {
      if (!asked.contains(output.path)) continue;
      if (output.read.together == nullptr) return std::nullopt;
      own.paths.push_back(output.path);
      own.follow_from_positions = own.follow_from_positions && output.read.together->read_one != nullptr;
    }
    found += own.paths.size();
    if (!own.paths.empty()) all.push_back(std::move(own));
  }
  if (found != asked.size()) return std::nullopt;
  return all;
}

/// Limits whose rows read where the links are.
bool has_limits_of_places(const Mechanism::Input& in) {
  return is_set(in.gamma_min) || std::any_of(in.joints.begin(), in.joints.end(), [](const planar::Joint& joint) {
           return is_set(joint.gamma_min) || is_set(joint.h_max);
         });
}

bool read_forces_alone(const std::vector<Wanted>& all) {
  return std::all_of(all.begin(), all.end(),
                     [](const Wanted& own) { return own.aspect->reads_forces_alone && own.follow_from_positions; });
}

}  // namespace

struct Ordinary::Parts {
  Parts(const Solved& solved, const account::Account& account, std::vector<Wanted> asked)
      : by_forces(read_forces_alone(asked) && !has_limits_of_places(solved.in)),
        columns(solved.given, solved.cycle.positions.size(), by_forces ? sizes : everything),
        modes(account.modes),
        verdicts(verdicts_of_numbers(solved)),
        wanted(std::move(asked)) {}

  void lay_cycle(const Solved& solved);
  void take_schedule(const Mechanism::Input& in, Axis& axis);
  void set_motion(const planar::Crank& crank);
  bool run(const Mechanism::Input& in);
  bool find_largest_reactions();
  [[nodiscard]] bool is_proved(const Mechanism::Input& in, const mechanism::Model& model);
  void find_told(const Solved& solved);
  std::vector<std::vector<double>> read_outputs();
  bool write_account(Solved& solved, account::Account& account);
  bool solve(const Mechanism::Input& in, const mechanism::Model& model, Axis& axis, account::Account& account);

  bool by_forces;  // whether all requested results follow from forces
  mechanism::CycleColumns columns;
  account::Modes modes;
  Verdicts verdicts;  // verdicts to be recomputed
  std::vector<Wanted> wanted;
  std::vector<Output> outputs;  // that of all of them
  mechanism::Structure structure;
  Cycle cycle;
  Kinematics kinematics;  // no requested result reads it
  std::optional<mechanism::Prover> prover;
  std::vector<mechanism::Drive> drives;
  double largest_force = 0.0;     // squared
  std::vector<double> numbers;    // of the crank, for a moment
  std::vector<double> scheduled;  // by which numbers of the crank the places were found
  std::vector<bool> heavy;        // which links have mass and inertia: what has none may be refused
  std::string step;
};

void Ordinary::Parts::lay_cycle(const Solved& solved) {
  const std::size_t count = solved.cycle.positions.size();
  step = solved.step;
  structure = solved.structure;
  heavy = heavy_links(solved.given);
  cycle.positions.assign(count, mechanism::blank_position(solved.given));
  cycle.closed.assign(count, true);
  cycle.at_change_point = cycle.in_steps = cycle.jams = cycle.undirected = cycle.some_rest =
      std::vector<bool>(count, false);
}

/// Positions and motion of the drives; the positions are recomputed only if they follow from other numbers.
void Ordinary::Parts::take_schedule(const Mechanism::Input& in, Axis& axis) {
  const double assembled = columns.coordinate(0);
  const double first = first_crank_angle(in.crank);
  numbers.assign({turning_sense(in.crank), static_cast<double>(in.crank.turns), static_cast<double>(in.crank.positions),
                  std::round((assembled - first) / (2.0 * pi))});
  for (const auto& place : in.crank.at) numbers.push_back(place.angle);
  numbers.push_back(first);
  if (numbers == scheduled) return set_motion(in.crank);
  scheduled = numbers;
  const Schedule schedule = schedule_of(in, [&](std::size_t driver) { return columns.coordinate(driver); });
  fill_axis(schedule, axis);
  cycle.drives = schedule.drives;
  drives.clear();
  for (const auto& at_position : schedule.drives) drives.push_back(at_position[0]);
}

/// The crank at its present places; most points leave its motion as it is.
void Ordinary::Parts::set_motion(const planar::Crank& crank) {
  const mechanism::Drive now = drive_of(crank, drives[0].coordinate);
  const mechanism::Drive& before = drives[0];
  if (now.speed == before.speed && now.acceleration == before.acceleration && now.impending == before.impending) return;
  for (std::size_t k = 0; k < drives.size(); ++k)
    drives[k] = cycle.drives[k][0] = drive_of(crank, drives[k].coordinate);
}

bool Ordinary::Parts::run(const Mechanism::Input& in) {
  const bool statics = leaves_out_inertia(in);
  if (columns.solve(drives, statics) != mechanism::Status::closed || !columns.in_lanes()) return false;
  if (!find_largest_reactions()) return false;
  if (!by_forces) columns.read(0, everything, cycle.positions);
  return true;
}

/// False if a force or moment is not finite.
bool Ordinary::Parts::find_largest_reactions() {
  std::vector<double>& largest = cycle.largest_reactions;
  largest.assign(cycle.positions.size(), 0.0);
  bool finite = sweep::all_finite(columns.effort(0));
  for (std::size_t j = 0; j < cycle.positions[0].reactions.size(); ++j) {
    finite = finite && mechanism::raise_to_squares(columns.force(j).x, columns.force(j).y, largest) &&
             sweep::all_finite(columns.couple(j));
  }
  largest_force = mechanism::largest_size(largest);
  mechanism::take_roots(largest);
  return finite;
}

/// By all methods, where it begins: clear of change points no position is harder to solve than another.
bool Ordinary::Parts::is_proved(const Mechanism::Input& in, const mechanism::Model& model) {
  const bool statics = leaves_out_inertia(in);
  if (prover) {
    prover->take_dimensions(model);
  } else {
    prover.emplace(model);
  }
  return prover->prove({drives.data(), 1}, statics, columns.first()).trustworthy();
}

/// Results from forces only depend on no number of the model.
void Ordinary::Parts::find_told(const Solved& solved) {
  if (by_forces && !outputs.empty()) return;
  outputs.clear();
  for (const Wanted& own : wanted) {
    for (Output& output : outputs_of(own, solved.in, solved.given)) outputs.push_back(std::move(output));
  }
}

/// Over all positions, a block of them after the other.
std::vector<std::vector<double>> Ordinary::Parts::read_outputs() {
  const std::size_t count = cycle.positions.size();
  std::vector<std::vector<double>> values(outputs.size(), std::vector<double>(count));
  for (std::size_t first = 0; first < count; first += block) {
    const std::span<mechanism::Position> now(cycle.positions.data(), std::min(block, count - first));
    columns.read(first, forces, now);
    for (std::size_t n = 0; n < outputs.size(); ++n) {
      const Reading& read = outputs[n].read;
      read.together->read_one(now, read.place, std::span(values[n]).subspan(first, now.size()));
    }
  }
  return values;
}

bool Ordinary::Parts::write_account(Solved& solved, account::Account& account) {
  find_told(solved);
  const Magnitudes largest = by_forces ? magnitudes_of(solved.given, columns, largest_force)
                                       : planar::magnitudes_of(solved.given, solved.cycle);
  std::vector<std::vector<double>> values;
  if (by_forces) {
    values = read_outputs();
    solved.values = &values;
  }
  account::Account found;
  fill_results(
      outputs, outputs, solved, largest, [](const std::string&) { return true; }, found);
  const bool known = std::all_of(found.results.begin(), found.results.end(),
                                 [](const account::Entry& entry) { return sweep::all_finite(entry.value.si); });
  if (!known) return false;
  account.results = std::move(found.results);
  if (account.modes.empty()) account.modes = modes;
  return true;
}

bool Ordinary::Parts::solve(const Mechanism::Input& in, const mechanism::Model& model, Axis& axis,
                            account::Account& account) {
  if (heavy_links(model) != heavy || columns.take(model) != mechanism::Status::closed) return false;
  if (!columns.is_regular_at_start()) return false;  // a singular stated position is reported
  if (has_short_segments(in)) return false;          // there may be positions to insert
  take_schedule(in, axis);
  if (drives.size() != cycle.positions.size() || !run(in)) return false;
  Solved solved{step, in, structure, model, model, cycle, cycle, kinematics, &axis};
  return are_alike(verdicts_of_numbers(solved), verdicts) && is_proved(in, model) && write_account(solved, account);
}

Ordinary::Ordinary(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Ordinary::~Ordinary() = default;

std::unique_ptr<Ordinary> Ordinary::of(const Solved& solved, const account::Account& account,
                                       const std::set<std::string>& asked) {
  if (!is_plain(solved)) return nullptr;
  auto wanted = wanted_of(solved, asked);
  if (!wanted) return nullptr;
  auto parts = std::make_unique<Parts>(solved, account, std::move(*wanted));
  const Verdicts held = settled_of(solved);
  const bool judged = parts->verdicts.size() + held.size() == account.verdicts.size();
  if (!judged || !all_pass(held) || !all_pass(parts->verdicts)) return nullptr;
  parts->lay_cycle(solved);
  return std::unique_ptr<Ordinary>(new Ordinary(std::move(parts)));
}

bool Ordinary::solve(const Mechanism::Input& in, const mechanism::Model& model, Axis& axis, account::Account& account) {
  const bool done = parts_->solve(in, model, axis, account);
  if (!done) parts_->scheduled.clear();  // the full solution leaves other places on the axis
  return done;
}

}  // namespace loadpath::planar
