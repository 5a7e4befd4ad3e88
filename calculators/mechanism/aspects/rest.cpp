// Friction of unknown direction: in a mechanism at rest, with impending motion in either direction, and in joints
// that rest for a moment while the others move, as at a dead point.
#include "calculators/mechanism/cycle/either_way.hpp"
#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/model/vec.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loadpath::planar {

namespace {

using account::Cell;
using account::Quantity;
using account::Table;
using mechanism::Position;

// ---- series

struct Standing {
  Declaration crank, cylinder;
  double StandingEffort::*effort;
};
constexpr const char* only_crank = "with friction and a crank as the only drive";
constexpr const char* only_cylinder = "with friction, as the only drive";
constexpr std::array standing_rows{
    Standing{declare("drive.M_backward", "driving torque that starts backward motion from rest; no inertia", N_m,
                     only_crank, {.is_load = true, .loads_crank = true}),
             declare("cylinders.NAME.F_backward", "driving force that starts backward motion from rest", N,
                     only_cylinder, {.is_load = true}),
             &StandingEffort::backward},
    Standing{declare("drive.M_forward", "driving torque that starts forward motion from rest; no inertia", N_m,
                     only_crank, {.is_load = true, .loads_crank = true}),
             declare("cylinders.NAME.F_forward", "driving force that starts forward motion from rest", N, only_cylinder,
                     {.is_load = true}),
             &StandingEffort::forward}};

/// Range of possible friction effects where joints rest.
struct Band {
  double least = std::numeric_limits<double>::infinity(), most = -least;

  /// NaN leaves no band.
  void take(double value) {
    least = std::isnan(value) || value < least ? value : least;
    most = std::isnan(value) || value > most ? value : most;
  }
  static Band open() { return {none, none}; }
};

template <class Read>
Band band_at(const Cycle& cycle, std::size_t k, Read read) {
  Band band;
  if (!cycle.has_forces(k)) return Band::open();
  band.take(read(cycle.positions[k]));
  if (cycle.either_way.empty()) return band;
  for (const Position& way : cycle.either_way[k]) {
    if (way.pose.empty()) return Band::open();  // it jams so: no effort is too large
    band.take(read(way));
  }
  return band;
}

Output::Values with_reason(std::vector<double> values) {
  const bool open = std::any_of(values.begin(), values.end(), [](double x) { return std::isnan(x); });
  return {std::move(values), open ? say("friction prevents motion in that direction at any effort") : Message{}};
}

constexpr Declaration drive_least =
    declare("drive.M_min", "minimum driving torque, friction of joints at rest in either direction", N_m,
            "with friction and a crank", {.is_load = true, .loads_crank = true});
constexpr Declaration drive_most = declare("drive.M_max", "maximum driving torque in this state", N_m,
                                           "with friction and a crank", {.is_load = true, .loads_crank = true});
constexpr Declaration cylinder_least =
    declare("cylinders.NAME.F_min", "minimum driving force, friction of joints at rest in either direction", N,
            "with friction", {.is_load = true});
constexpr Declaration cylinder_most =
    declare("cylinders.NAME.F_max", "maximum driving force in this state", N, "with friction", {.is_load = true});
constexpr Declaration joint_most =
    declare("joints.NAME.F_max", "maximum magnitude of the joint force, friction of joints at rest in either direction",
            N, "with friction", {.tabled = Tabled::at_one_position, .is_load = true});

template <class Read>
void add_end(const Declaration& what, const std::string& name, double Band::*end, Read read, std::vector<Output>& out) {
  const auto over_cycle = [read, end](const Solved& solved) {
    const Cycle& cycle = solved.cycle;
    std::vector<double> values;
    for (std::size_t k = 0; k < cycle.positions.size(); ++k) values.push_back(band_at(cycle, k, read).*end);
    return with_reason(std::move(values));
  };
  out.push_back(output(what, name));
  out.back().read_cycle = over_cycle;
}

void add_standing(const mechanism::Driver& driver, std::vector<Output>& out) {
  const bool rotary = driver.kind == mechanism::Driver::Kind::rotary;
  for (const Standing& row : standing_rows) {
    out.push_back(output(rotary ? row.crank : row.cylinder, driver.name));
    out.back().read_cycle = [effort = row.effort](const Solved& solved) {
      const Cycle& cycle = solved.cycle;
      std::vector<double> values(cycle.positions.size(), none);
      for (std::size_t k = 0; k < cycle.standing.size(); ++k)
        values[k] = cycle.closed[k] ? cycle.standing[k].*effort : none;
      return with_reason(std::move(values));
    };
  }
}

// ---- tables

/// "from 30 deg to 60 deg, from 200 deg to 210 deg", as far as positions show.
Message ranges(const std::vector<bool>& positions, const Axis& axis) {
  constexpr std::size_t most = 4;
  const auto runs = runs_of(positions, true, axis.cyclic());
  if (runs.empty()) return say("nowhere");
  if (runs.front().count == positions.size()) return say("at every position");
  Message all;
  for (std::size_t n = 0; n < std::min(runs.size(), most); ++n) {
    const std::string first = place_of(runs[n].first, axis), last = place_of(runs[n].last, axis);
    const Message run = runs[n].count == 1 ? say("at {1}", first) : say("from {1} to {2}", first, last);
    all = n == 0 ? run : say("{1}, {2}", all, run);
  }
  return runs.size() > most ? say("{1}, and {2} more", all, std::to_string(runs.size() - most)) : all;
}

/// Coefficients of friction that are all the same can be named.
std::optional<double> common_coefficient(const mechanism::Model& model) {
  std::optional<double> mu;
  for (const mechanism::Joint& joint : model.joints) {
    const mechanism::Friction& f = joint.friction;
    if (f.rolling_arm > 0.0 || f.loss > 0.0 || f.loss_back > 0.0) return {};
    if (f.coefficient == 0.0) continue;
    if (f.rise > 0.0) return {};  // it has two
    if (mu && *mu != f.coefficient) return {};
    mu = f.coefficient;
  }
  return mu;
}

class StandingTable {
 public:
  StandingTable(const mechanism::Model& model, const Cycle& cycle, const Axis* axis)
      : model_(model), cycle_(cycle), axis_(axis) {
    unit_ = model.drivers[0].kind == mechanism::Driver::Kind::rotary ? "N*m" : "N";
  }

  Table made() {
    add_extreme(say("effort of the drive that starts it forward, no inertia"), &StandingEffort::forward, true);
    add_extreme(say("effort that starts it backward"), &StandingEffort::backward, false);
    add_jamming(say("no effort starts it forward"), &StandingEffort::forward);
    add_jamming(say("no effort starts it backward"), &StandingEffort::backward);
    const auto stands = [this](std::size_t k) { return cycle_.standing[k].stands(); };
    add(say("at rest without its drive"), where(stands));
    add_threshold(say("minimum friction for self-locking, as a fraction of the given friction"),
                  cycle_.stands_somewhere);
    if (axis_ != nullptr) add_threshold(say("the same for every position"), cycle_.stands_everywhere);
    return std::move(table_);
  }

 private:
  void add(Message what, Cell value) { table_.rows.push_back({std::move(what), std::move(value)}); }

  template <class Holds>
  [[nodiscard]] Cell where(Holds holds) const {
    if (axis_ == nullptr) return holds(0) ? say("yes") : say("no");
    std::vector<bool> held(cycle_.positions.size());
    for (std::size_t k = 0; k < held.size(); ++k) held[k] = holds(k);
    return ranges(held, *axis_);
  }

  /// The largest effort required; backward the smallest.
  void add_extreme(Message what, double StandingEffort::*effort, bool largest) {
    std::optional<std::size_t> at;
    for (std::size_t k = 0; k < cycle_.standing.size(); ++k) {
      const double here = cycle_.standing[k].*effort;
      if (std::isnan(here)) continue;
      const double best = at ? cycle_.standing[*at].*effort : here;
      if (!at || (largest ? numerics::exceeds(here, best) : numerics::exceeds(best, here))) at = k;
    }
    if (!at) return;
    const Quantity value{cycle_.standing[*at].*effort, unit_};
    if (axis_ == nullptr) return add(std::move(what), value);
    const Message extreme = largest ? say("{1}: maximum, at {2}", what, place_of(*at, *axis_))
                                    : say("{1}: minimum, at {2}", what, place_of(*at, *axis_));
    add(extreme, value);
  }

  void add_jamming(Message what, double StandingEffort::*effort) {
    const auto jams = [&](std::size_t k) { return cycle_.standing[k].known && std::isnan(cycle_.standing[k].*effort); };
    for (std::size_t k = 0; k < cycle_.standing.size(); ++k) {
      if (jams(k)) return add(std::move(what), where(jams));
    }
  }

  void add_threshold(const Message& what, const std::optional<Cycle::Threshold>& threshold) {
    if (!threshold) return;
    const auto& [share, at] = *threshold;
    add(axis_ == nullptr ? what : say("{1}; at {2}", what, place_of(at, *axis_)), Quantity{share, "-", 4});
    if (const auto mu = common_coefficient(model_))
      add(say("coefficient of friction then"), Quantity{share * *mu, "-", 4});
  }

  const mechanism::Model& model_;
  const Cycle& cycle_;
  const Axis* axis_;
  std::string unit_;
  Table table_{say("At rest: breakaway effort and self-locking positions"), {}, {}};
};

/// Rows of differing results: with the friction in one direction and the other.
void add_difference(const std::string& place, const std::string& what, const std::string& unit, const Band& band,
                    Table& table) {
  const double size = std::max(std::abs(band.least), std::abs(band.most));
  if (!(band.most - band.least > 1e-9 * size)) return;
  table.rows.push_back({place, what, Quantity{band.least, unit}, Quantity{band.most, unit}});
}

void add_rest(const Mechanism::Input&, const mechanism::Model& model, std::vector<Output>& out) {
  if (!has_dry_friction(model) || model.drivers.empty()) return;
  if (model.drivers.size() == 1) add_standing(model.drivers[0], out);
  for (std::size_t d = 0; d < model.drivers.size(); ++d) {
    const auto effort = [d](const Position& p) { return p.effort[d]; };
    const bool rotary = model.drivers[d].kind == mechanism::Driver::Kind::rotary;
    add_end(rotary ? drive_least : cylinder_least, model.drivers[d].name, &Band::least, effort, out);
    add_end(rotary ? drive_most : cylinder_most, model.drivers[d].name, &Band::most, effort, out);
  }
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const auto force = [j](const Position& p) { return mechanism::length(p.reactions[j].force); };
    add_end(joint_most, model.joints[j].name, &Band::most, force, out);
  }
}

void list_rest(std::vector<ResultPattern>& patterns) {
  for (const Standing& row : standing_rows) {
    patterns.push_back(row.crank.pattern);
    patterns.push_back(row.cylinder.pattern);
  }
  for (const Declaration& d : {drive_least, drive_most, cylinder_least, cylinder_most, joint_most})
    patterns.push_back(d.pattern);
}

/// Efforts to start the mechanism, and its rest without drive; none without friction or with several drives.
std::optional<Table> standing_table(const mechanism::Model& model, const Cycle& cycle, const Axis* axis) {
  if (cycle.standing.empty() || std::find(cycle.closed.begin(), cycle.closed.end(), true) == cycle.closed.end())
    return {};
  return StandingTable(model, cycle, axis).made();
}

/// The positions where joints rest while others move, with the forces that their friction may make.
std::optional<Table> dead_point_table(const mechanism::Model& model, const Cycle& cycle, const Axis* axis) {
  constexpr int most_positions = 6;
  Table table{
      say("Joints at rest, friction in either direction"), {say("at"), say("quantity"), say("from"), say("to")}, {}};
  int resting = 0;
  for (std::size_t k = 0; k < cycle.either_way.size(); ++k) {
    if (cycle.either_way[k].empty() || ++resting > most_positions) continue;
    const std::string place = axis == nullptr ? "–" : place_of(k, *axis);
    for (std::size_t d = 0; d < model.drivers.size(); ++d) {
      const bool rotary = model.drivers[d].kind == mechanism::Driver::Kind::rotary;
      const Band band = band_at(cycle, k, [d](const Position& p) { return p.effort[d]; });
      add_difference(place, rotary ? "drive.M" : "cylinders." + model.drivers[d].name + ".F", rotary ? "N*m" : "N",
                     band, table);
    }
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
      const Band band = band_at(cycle, k, [j](const Position& p) { return mechanism::length(p.reactions[j].force); });
      add_difference(place, "joints." + model.joints[j].name + ".F", "N", band, table);
    }
  }
  if (resting > most_positions)
    table.caption = say("{1}: the first {2} of {3} positions", table.caption, std::to_string(most_positions),
                        std::to_string(resting));
  if (table.rows.empty()) return {};
  return table;
}

void check(const Mechanism::Input& in, const mechanism::Model& model, std::vector<FieldFault>& faults) {
  append(check_rest(in, model), faults);
}

void show_rest(const Solved& solved, const Results&, std::vector<account::Block>& blocks) {
  if (auto standing = standing_table(solved.model, solved.cycle, solved.axis))
    blocks.emplace_back(std::move(*standing));
  if (auto resting = dead_point_table(solved.model, solved.cycle, solved.axis))
    blocks.emplace_back(std::move(*resting));
}

}  // namespace

constinit const Aspect aspects::rest{
    .check_values = &check, .list = &list_rest, .add_outputs = &add_rest, .show = &show_rest};

}  // namespace loadpath::planar
