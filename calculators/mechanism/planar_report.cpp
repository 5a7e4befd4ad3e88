#include "calculators/mechanism/planar_report.hpp"

#include "calculators/mechanism/planar_model.hpp"
#include "lib/mechanism/assur.hpp"
#include "lib/mechanism/vec.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loadpath {

namespace {

using Planar = PlanarMechanism;
using report::Cell;
using report::Quantity;
using report::Table;

std::string text(const Name& name) { return std::string(name.view()); }

std::string names_of_points(const Planar::Link& link) {
  std::string all;
  for (const auto& p : link.points) all += (all.empty() ? "" : ", ") + text(p.name);
  return all;
}

Table link_table(const Planar::Input& in) {
  Table table{
      say("Links"), {say("link"), say("points"), say("mass"), say("moment of inertia"), say("mass centre")}, {}};
  for (const auto& l : in.links) {
    table.rows.push_back({text(l.name), names_of_points(l), Quantity{in_si(l.mass), "kg"},
                          Quantity{in_si(l.J), "kg*m^2"}, l.S.empty() ? Cell(say("origin")) : Cell(text(l.S))});
  }
  return table;
}

Table point_table(const Planar::Input& in) {
  Table table{say("Points, in the axes of their link"), {say("point"), say("link"), say("x"), say("y")}, {}};
  const auto add = [&](const Planar::Point& p, const std::string& link) {
    const mechanism::Vec v = vector_of(p);
    table.rows.push_back({text(p.name), link, Quantity{v.x, "mm"}, Quantity{v.y, "mm"}});
  };
  for (const auto& p : in.ground) add(p, "ground");
  for (const auto& l : in.links) {
    for (const auto& p : l.points) add(p, text(l.name));
  }
  return table;
}

Table joint_table(const Planar::Input& in) {
  Table table{
      say("Joints"),
      {say("joint"), say("kind"), say("first link"), say("point"), say("second link"), say("point"), say("direction")},
      {}};
  constexpr auto types = choices_of(Planar::Type{});
  for (const auto& j : in.joints) {
    const auto type = std::find_if(types.begin(), types.end(), [&](const auto& t) { return t.value == j.type; });
    const auto [first, second] = point_names(j);
    const Cell direction =
        j.type == Planar::Type::revolute ? Cell(std::string("–")) : Cell(Quantity{j.direction, "deg"});
    table.rows.push_back({text(j.name), say(type->key), text(j.links.first), text(first), text(j.links.second),
                          text(second), direction});
  }
  return table;
}

Table load_table(const Planar::Input& in) {
  Table table{say("Loads"),
              {say("load"), say("link"), say("point"), say("force"), say("direction"), say("couple"), say("axes")},
              {}};
  for (const auto& l : in.loads) {
    const bool cartesian = is_set(l.F_x);
    const double fx = in_si(l.F_x), fy = in_si(l.F_y);
    const Cell none = std::string("–");
    const Cell force = is_set(l.F) ? Cell(Quantity{in_si(l.F), "N"})
                       : cartesian ? Cell(Quantity{std::hypot(fx, fy), "N"})
                                   : none;
    const Cell direction = is_set(l.F) ? Cell(Quantity{l.direction, "deg"})
                           : cartesian ? Cell(Quantity{std::atan2(fy, fx), "deg"})
                                       : none;
    table.rows.push_back({l.name.empty() ? none : Cell(text(l.name)), text(l.link),
                          l.at.empty() ? none : Cell(text(l.at)), force, direction,
                          is_set(l.M) ? Cell(Quantity{in_si(l.M), "N*m"}) : none,
                          l.axes == Planar::Axes::link ? say("of the link") : say("fixed")});
  }
  return table;
}

Table drive_table(const Planar::Input& in) {
  Table table{say("Drive"), {}, {}};
  if (!in.crank.joint.empty()) {
    table.rows.push_back({say("driven joint"), text(in.crank.joint)});
    table.rows.push_back({say("angular speed"), Quantity{in_si(in.crank.speed), "rad/s"}});
    table.rows.push_back({say("angular acceleration"), Quantity{in_si(in.crank.acceleration), "rad/s^2"}});
    const bool turn = in.crank.at.empty();
    table.rows.push_back({say("first crank angle"), Quantity{first_crank_angle(in.crank), "deg"}});
    table.rows.push_back(
        {say("positions"), std::to_string(turn ? static_cast<std::size_t>(in.crank.positions) : in.crank.at.size())});
  }
  for (const auto& c : in.cylinders) table.rows.push_back({text(c.name), text(c.joint)});
  table.rows.push_back({say("gravity"), Quantity{in_si(in.gravity), "m/s^2"}});
  if (in_si(in.gravity) != 0.0)
    table.rows.push_back({say("direction of gravity"), Quantity{in.gravity_direction, "deg"}});
  table.rows.push_back(
      {say("inertia of the links"), in.analysis == Planar::Analysis::statics ? say("left out") : say("included")});
  return table;
}

/// Drives and joint forces: what parts are designed for.
bool is_design_load(const std::string& path) {
  return path == "drive.M" || path == "drive.P" || path.starts_with("cylinders.") ||
         (path.starts_with("joints.") && !path.ends_with(".x") && !path.ends_with(".y"));
}

/// The mean, with what rounding has left of a zero taken as one.
double mean_of(const Value& series) {
  const double average = mean(series);
  return std::abs(average) < 1e-12 * std::abs(largest(series).value) ? 0.0 : average;
}

Table extremes_table(const project::Account& account, const Axis& axis) {
  Table table{say("Extremes over the cycle"),
              {say("quantity"), say("largest"), say("at"), say("smallest"), say("at"), say("mean")},
              {}};
  for (const project::Entry& e : account.results) {
    if (!is_design_load(e.path)) continue;
    const Extreme high = maximum(e.value), low = minimum(e.value);
    table.rows.push_back({e.path, Quantity{high.value, e.unit}, Quantity{high.at, axis.unit},
                          Quantity{low.value, e.unit}, Quantity{low.at, axis.unit},
                          Quantity{mean_of(e.value), e.unit}});
  }
  return table;
}

Table position_table(const project::Account& account) {
  Table table{say("Drive and reactions"), {say("quantity"), say("value"), say("meaning")}, {}};
  for (const project::Entry& e : account.results) {
    if (is_design_load(e.path) || e.path.starts_with("joints."))
      table.rows.push_back({e.path, Quantity{e.value.si[0], e.unit}, say("{1}", e.doc)});
  }
  return table;
}

/// "2 · 3 + 0 = 6": what the joints take away from the links of a group.
std::string count_of(const mechanism::Group& group) {
  const auto drives = group.drivers.size();
  return std::to_string(3 * group.links.size()) + " = 2 · " + std::to_string(group.p5) + " + " +
         std::to_string(group.p4) + (drives == 0 ? "" : " + " + std::to_string(drives));
}

template <class Parts>
std::string listed(const Parts& parts, const std::vector<std::size_t>& chosen) {
  std::string names;
  for (const std::size_t k : chosen) names += (names.empty() ? "" : ", ") + parts[k].name;
  return names;
}

Message kind_of(const mechanism::Group& group) {
  static constexpr std::array roman{"", "I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
  if (group.contour_class == 1) return say("initial link");
  const auto k = static_cast<std::size_t>(group.contour_class);
  const std::string number = k < roman.size() ? roman[k] : std::to_string(k);
  const Message group_class = say("class {1}, order {2}", number, std::to_string(group.order));
  return group.kind.empty() ? group_class : say("{1}, {2}", group_class.text(), group.kind);
}

Table structure_table(const mechanism::Model& model) {
  Table table{say("Structure: groups in order of attachment, 3 n = 2 p5 + p4 + drives"),
              {say("links"), say("joints"), say("kind"), say("count")},
              {}};
  for (const mechanism::Group& group : mechanism::groups(model)) {
    table.rows.push_back(
        {listed(model.links, group.links), listed(model.joints, group.joints), kind_of(group), count_of(group)});
  }
  return table;
}

Table determinacy_table(const mechanism::Structure& structure, const Cycle& cycle, const Axis* axis) {
  Table table{say("Mobility and conditioning"), {}, {}};
  table.rows.push_back(
      {say("mobility by count, 3 n − 2 p5 − p4; drives not counted"), std::to_string(structure.mobility_by_count)});
  table.rows.push_back({say("mobility by rank of the constraints"), std::to_string(structure.mobility)});
  if (cycle.worst_condition == 0.0) return table;
  const Message largest = say("largest condition number of constraints and drives, 1-norm, estimated");
  table.rows.push_back(
      {axis == nullptr ? largest
                       : say("{1}, at {2}", largest.text(), format_quantity(axis->at[cycle.worst_at], axis->unit, 5)),
       Quantity{cycle.worst_condition, "-", 2}});
  return table;
}

report::Verdict limit(const std::string& step, const char* symbol, Message meaning, double value, double bound) {
  report::Verdict v;
  v.step = step;
  v.symbol = symbol;
  v.meaning = std::move(meaning);
  v.bound = say("at most {1}", format_number(bound));
  v.value = Quantity{value, "-", 2};
  v.state = std::isnan(value) ? report::State::not_available
            : value <= bound  ? report::State::pass
                              : report::State::fail;
  return v;
}

Message why_open(const Planar::Input& in, const Cycle& cycle) {
  if (cycle.first_failure == mechanism::Status::singular) return say("the drive cannot hold the mechanism there");
  if (cycle.gap.joint < 0) return say("the drive could not be followed to its place");
  return say("joint '{1}' stays {2} apart", text(in.joints[static_cast<std::size_t>(cycle.gap.joint)].name),
             format_quantity(cycle.gap.size, "mm", 4));
}

report::Verdict closing(const std::string& step, const Planar::Input& in, const Cycle& cycle, const Axis* axis) {
  report::Verdict v;
  v.step = step;
  v.symbol = "closes";
  v.meaning = say("the mechanism closes at every position");
  v.bound = say("every position");
  const auto closed = static_cast<std::size_t>(std::count(cycle.closed.begin(), cycle.closed.end(), true));
  v.value = say("{1} of {2}", std::to_string(closed), std::to_string(cycle.closed.size()));
  v.state = closed == cycle.closed.size() ? report::State::pass : report::State::fail;
  if (v.state == report::State::pass) return v;
  v.note = why_open(in, cycle);
  if (axis == nullptr) return v;
  const auto first = std::find(cycle.closed.begin(), cycle.closed.end(), false) - cycle.closed.begin();
  const auto last = std::find(cycle.closed.rbegin(), cycle.closed.rend(), false).base() - cycle.closed.begin() - 1;
  const auto place = [&](std::ptrdiff_t k) {
    return format_quantity(axis->at[static_cast<std::size_t>(k)], axis->unit, 5);
  };
  v.note = say("between {1} and {2}: {3}", place(first), place(last), v.note.text());
  return v;
}

}  // namespace

std::vector<report::Block> model_tables(const Planar::Input& in) {
  std::vector<report::Block> blocks{drive_table(in), link_table(in), point_table(in), joint_table(in)};
  if (!in.loads.empty()) blocks.emplace_back(load_table(in));
  return blocks;
}

std::vector<report::Block> result_tables(const project::Account& account, const mechanism::Model& model,
                                         const mechanism::Structure& structure, const Cycle& cycle, const Axis* axis) {
  return {axis == nullptr ? position_table(account) : extremes_table(account, *axis), structure_table(model),
          determinacy_table(structure, cycle, axis)};
}

namespace {

/// The larger magnitude; what is not a number stays so.
double larger(double most, double x) { return std::isnan(most) || std::abs(x) <= most ? most : std::abs(x); }

/// A residual as a part of what it is a residual of; of nothing it is zero. What cannot be told is no number.
double part_of(double residual, double scale) {
  if (!std::isfinite(residual) || !std::isfinite(scale)) return std::numeric_limits<double>::quiet_NaN();
  if (scale > 0.0) return residual / scale;
  return residual == 0.0 ? 0.0 : std::numeric_limits<double>::quiet_NaN();
}

/// The largest of what is left over, and of what it is left over from, over the positions that close.
struct Leftovers {
  double force = 0.0, largest_force = 0.0;    // N
  double moment = 0.0, largest_moment = 0.0;  // N m
  double power = 0.0, largest_power = 0.0;    // W
  bool any = false;

  void add_force(mechanism::Vec force_there, mechanism::Vec at) {
    largest_force = larger(largest_force, mechanism::length(force_there));
    largest_moment = larger(largest_moment, mechanism::length(force_there) * mechanism::length(at));
  }
  /// The effort of a crank is a moment, that of a cylinder a force.
  void add(const mechanism::Position& p, const mechanism::Residuals& r, bool crank) {
    any = true;
    force = larger(force, r.force);
    moment = larger(moment, r.moment);
    power = larger(power, r.power);
    largest_power = larger(largest_power, r.power_scale);
    for (const auto& reaction : p.reactions) {
      add_force(reaction.force, reaction.at);
      largest_moment = larger(largest_moment, reaction.couple);
    }
    for (std::size_t d = 0; d < p.effort.size(); ++d) {
      double& largest = d == 0 && crank ? largest_moment : largest_force;
      largest = larger(largest, p.effort[d]);
    }
  }
};

}  // namespace

std::vector<report::Verdict> proof(const std::string& step, const Planar::Input& in, const Cycle& cycle,
                                   const Axis* axis) {
  Leftovers left;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (cycle.closed[k]) left.add(cycle.positions[k], cycle.residuals[k], !in.crank.joint.empty());
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto part = [&](double residual, double scale) { return left.any ? part_of(residual, scale) : none; };
  std::vector<report::Verdict> verdicts{closing(step, in, cycle, axis)};
  verdicts.push_back(limit(step, "force_balance",
                           say("equilibrium of every link: unbalanced force over the largest reaction"),
                           part(left.force, left.largest_force), 1e-9));
  verdicts.push_back(limit(step, "moment_balance", say("equilibrium of every link: unbalanced moment over the largest"),
                           part(left.moment, left.largest_moment), 1e-9));
  if (!in.crank.joint.empty() || !in.cylinders.empty()) {
    verdicts.push_back(limit(step, "power_balance",
                             say("power of drive, loads and weights against the change of kinetic energy"),
                             part(left.power, left.largest_power), 1e-9));
  }
  return verdicts;
}

}  // namespace loadpath
