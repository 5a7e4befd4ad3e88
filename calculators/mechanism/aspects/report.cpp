#include "calculators/mechanism/aspects/report.hpp"

#include "calculators/mechanism/aspects/accuracy.hpp"
#include "calculators/mechanism/aspects/efficiency.hpp"
#include "calculators/mechanism/aspects/flanks.hpp"
#include "calculators/mechanism/aspects/masses.hpp"
#include "calculators/mechanism/aspects/rest.hpp"
#include "calculators/mechanism/proof/redundancy.hpp"
#include "calculators/mechanism/results/cams.hpp"
#include "calculators/mechanism/words/joints.hpp"
#include "calculators/mechanism/words/loads.hpp"
#include "calculators/mechanism/words/names.hpp"
#include "calculators/mechanism/words/points.hpp"
#include "calculators/mechanism/words/profiles.hpp"
#include "lib/mechanism/model/vec.hpp"
#include "lib/mechanism/structure/assur.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace loadpath::planar {

namespace {

using account::Cell;
using account::Quantity;
using account::Table;

std::string names_of_points(const planar::Link& link) {
  std::string all;
  for (const auto& p : link.points) all += (all.empty() ? "" : ", ") + text(p.name);
  return all;
}

Table link_table(const Mechanism::Input& in) {
  Table table{
      say("Links"), {say("link"), say("points"), say("mass"), say("moment of inertia"), say("mass centre")}, {}};
  for (const auto& l : in.links) {
    table.rows.push_back({text(l.name), names_of_points(l), Quantity{in_si(l.mass), "kg"},
                          Quantity{in_si(l.J), "kg*m^2"}, l.S.empty() ? Cell(say("origin")) : Cell(text(l.S))});
  }
  return table;
}

Table point_table(const Mechanism::Input& in) {
  Table table{say("Points, in the axes of their link"), {say("point"), say("link"), say("x"), say("y")}, {}};
  const auto add = [&](const planar::Point& p, const std::string& link) {
    const mechanism::Vec v = vector_of(p);
    table.rows.push_back({text(p.name), link, Quantity{v.x, "mm"}, Quantity{v.y, "mm"}});
  };
  for (const auto& p : in.ground) add(p, "ground");
  for (const auto& l : in.links) {
    for (const auto& p : l.points) add(p, text(l.name));
  }
  return table;
}

Table joint_table(const Mechanism::Input& in) {
  Table table{
      say("Joints"),
      {say("joint"), say("kind"), say("first link"), say("point"), say("second link"), say("point"), say("direction")},
      {}};
  for (const auto& j : in.joints) {
    const auto [first, second] = point_names(j);
    const Cell direction =
        j.type == planar::Type::revolute ? Cell(std::string("–")) : Cell(Quantity{j.direction, "deg"});
    table.rows.push_back({text(j.name), say(word_of(j.type)), text(j.links.first), text(first), text(j.links.second),
                          text(second), direction});
  }
  return table;
}

void add_sense(Message what, planar::Impending impending, Table& table) {
  if (impending == planar::Impending::either) return;
  table.rows.push_back({std::move(what), impending == planar::Impending::forward ? say("forward") : say("backward")});
}

/// "from the x axis to point A of crank": between what the crank angle is measured.
Message crank_angle_of(const Mechanism::Input& in) {
  const planar::Joint* const joint = find_named(in.joints, in.crank.joint);
  const bool first_fixed = joint->links.first.view() == "ground";
  const Name &link = first_fixed ? joint->links.second : joint->links.first,
             &base = first_fixed ? joint->links.first : joint->links.second;
  const Message from = base.view() == "ground" ? say("from the x axis") : say("from {1}'s own x axis", text(base));
  return in.crank.to.empty() ? say("{1} to {2}'s own x axis", from, text(link))
                             : say("{1} to point {2} of {3}", from, text(in.crank.to), text(link));
}

Table drive_table(const Mechanism::Input& in) {
  Table table{say("Drive"), {}, {}};
  if (!in.crank.joint.empty()) {
    table.rows.push_back({say("driven joint"), text(in.crank.joint)});
    table.rows.push_back({say("crank angle"), crank_angle_of(in)});
    for (const auto& moment : in.crank.law)
      table.rows.push_back(
          {say("crank angle at {1}", format_quantity(in_si(moment.t), "s")), Quantity{moment.angle, "deg"}});
    if (!in.crank.angle_of_t.empty()) {
      table.rows.push_back({say("crank angle at t"), std::string(in.crank.angle_of_t.view())});
      table.rows.push_back({say("for"), Quantity{in_si(in.crank.duration), "s"}});
    } else if (in.crank.law.empty()) {
      table.rows.push_back({say("angular speed"), Quantity{in_si(in.crank.speed), "rad/s"}});
      table.rows.push_back({say("angular acceleration"), Quantity{in_si(in.crank.acceleration), "rad/s^2"}});
    }
    add_sense(say("about to turn"), in.crank.impending, table);
    const bool turn = in.crank.at.empty();
    if (!has_law(in)) table.rows.push_back({say("first crank angle"), Quantity{first_crank_angle(in.crank), "deg"}});
    table.rows.push_back(
        {say("positions"), std::to_string(turn ? static_cast<std::size_t>(in.crank.positions) : in.crank.at.size())});
  }
  for (const auto& c : in.cylinders) {
    table.rows.push_back({text(c.name), text(c.joint)});
    add_sense(say("{1} is about to move", text(c.name)), c.impending, table);
    if (!c.place_of_t.empty()) {
      table.rows.push_back({say("place of {1} at t", text(c.name)), std::string(c.place_of_t.view())});
      table.rows.push_back({say("for"), Quantity{in_si(c.duration), "s"}});
    }
    for (const auto& moment : c.law) {
      table.rows.push_back({say("place of {1} at {2}", text(c.name), format_quantity(in_si(moment.t), "s")),
                            Quantity{in_si(moment.place), "mm"}});
    }
  }
  table.rows.push_back({say("gravity"), Quantity{in_si(in.gravity), "m/s^2"}});
  if (in_si(in.gravity) != 0.0)
    table.rows.push_back({say("direction of gravity"), Quantity{in.gravity_direction, "deg"}});
  table.rows.push_back(
      {say("inertia of the links"), in.analysis == Mechanism::Analysis::statics ? say("left out") : say("included")});
  return table;
}

/// Drives and joint forces: what parts are designed for.
bool is_design_load(const std::string& path) {
  const bool internal =
      path.starts_with("links.") && (path.ends_with(".N") || path.ends_with(".V") || path.ends_with(".M_b"));
  const bool joint = path.starts_with("joints.") &&
                     (path.ends_with(".F") || path.ends_with(".M") || path.ends_with(".N") || path.ends_with(".F_t") ||
                      path.ends_with(".F_r") || path.ends_with(".N_front") || path.ends_with(".N_back"));
  const bool of_rest = path.ends_with("_min") || path.ends_with("_max") || path.ends_with("_forward") ||
                       path.ends_with("_backward");  // tables of their own
  if (of_rest) return false;
  return internal || joint || path.starts_with("springs.") || path.starts_with("drive.") || path == "frame.F" ||
         path == "frame.M" || path.starts_with("cylinders.");
}

/// The mean, with what rounding has left of a zero taken as one.
double mean_of(const Value& series) {
  const double average = mean(series);
  const double rounding = std::max(series.rounding, 1e-12 * std::abs(largest(series).value));
  return std::abs(average) < rounding ? 0.0 : average;
}

/// A value of a result, or why it is missing.
Cell value_cell(const account::Entry& e, double si) {
  const bool told = std::isnan(si) && !e.missing.empty();
  return told ? Cell(say("not available: {1}", e.missing)) : Cell(Quantity{si, e.unit});
}

/// What is not unique is told in a table of its own.
Table extremes_table(const account::Account& account, const Cycle& cycle, const Axis& axis) {
  Table table{axis.cyclic() ? say("Extremes over the cycle") : say("Extremes over the positions"),
              {say("quantity"), say("largest"), say("at"), say("smallest"), say("at")},
              {}};
  if (axis.cyclic()) table.head.insert(table.head.end(), {say("mean"), say("rms")});
  for (const account::Entry& e : account.results) {
    if (!is_design_load(e.path) || !e.value.is_series() || is_constant(e.value)) continue;
    if (!cycle.unique.empty() && is_open(e)) continue;
    const Extreme high = maximum(e.value), low = minimum(e.value);
    std::vector<Cell> row{e.path, value_cell(e, high.value), Quantity{high.at, axis.unit}, Quantity{low.value, e.unit},
                          Quantity{low.at, axis.unit}};
    if (axis.cyclic())
      row.insert(row.end(), {Quantity{mean_of(e.value), e.unit}, Quantity{root_mean_square(e.value), e.unit}});
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// What has no extremes.
std::optional<Table> constant_table(const account::Account& account, const Axis& axis) {
  Table table{axis.cyclic() ? say("Constant over the cycle") : say("Constant over the positions"),
              {say("quantity"), say("value"), say("meaning")},
              {}};
  for (const account::Entry& e : account.results) {
    if (!is_design_load(e.path) || !e.value.is_series() || !is_constant(e.value)) continue;
    table.rows.push_back({e.path, Quantity{e.value.si.front(), e.unit}, say("{1}", e.doc)});
  }
  if (table.rows.empty()) return std::nullopt;
  return table;
}

Table position_table(const account::Account& account) {
  Table table{say("Drive and reactions"), {say("quantity"), say("value"), say("meaning")}, {}};
  for (const account::Entry& e : account.results) {
    if (!is_design_load(e.path) && !(e.path.starts_with("joints.") && e.value.signature.dimension == N.dimension()))
      continue;
    table.rows.push_back({e.path, value_cell(e, e.value.si[0]), say("{1}", e.doc)});
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
  return group.kind.empty() ? group_class : say("{1}, {2}", group_class, group.kind);
}

Table structure_table(const mechanism::Model& model, bool released) {
  Table table{released
                  ? say("Structure, without what joints hold too much: groups in order of attachment, 3 n = 2 p5 + "
                        "p4 + drives")
                  : say("Structure: groups in order of attachment, 3 n = 2 p5 + p4 + drives"),
              {say("links"), say("joints"), say("kind"), say("count")},
              {}};
  for (const mechanism::Group& group : mechanism::groups(model)) {
    table.rows.push_back(
        {listed(model.links, group.links), listed(model.joints, group.joints), kind_of(group), count_of(group)});
  }
  return table;
}

Table determinacy_table(const mechanism::Model& model, const mechanism::Structure& structure, const Cycle& cycle,
                        const Axis* axis) {
  Table table{say("Mobility and conditioning"), {}, {}};
  table.rows.push_back(
      {say("mobility by count, 3 n − 2 p5 − p4; drives not counted"), std::to_string(structure.mobility_by_count)});
  table.rows.push_back({say("mobility by rank of the constraints"), std::to_string(structure.mobility)});
  for (const std::string& name : passive_freedoms(model)) {
    table.rows.push_back(
        {say("passive freedom, not counted: the roller of '{1}' turns freely", name), std::string("1")});
  }
  const auto steps = std::count(cycle.in_steps.begin(), cycle.in_steps.end(), true);
  if (steps > 0 && axis != nullptr) {
    const auto first = std::find(cycle.in_steps.begin(), cycle.in_steps.end(), true) - cycle.in_steps.begin();
    table.rows.push_back({say("positions that were followed in small steps; first at {1}",
                              format_quantity(axis->at[static_cast<std::size_t>(first)], axis->unit, 5)),
                          std::to_string(steps)});
  }
  if (cycle.worst_condition == 0.0) return table;
  const Message largest = say("largest condition number of constraints and drives, 1-norm");
  table.rows.push_back({axis == nullptr
                            ? largest
                            : say("{1}, at {2}", largest, format_quantity(axis->at[cycle.worst_at], axis->unit, 5)),
                        Quantity{cycle.worst_condition, "-", 2}});
  return table;
}

}  // namespace

std::vector<account::Block> model_tables(const Mechanism::Input& in) {
  std::vector<account::Block> blocks{drive_table(in), link_table(in), point_table(in), joint_table(in)};
  if (auto reductions = reduction_table(in)) blocks.emplace_back(std::move(*reductions));
  for (account::Table& table : detail_tables(in)) blocks.emplace_back(std::move(table));
  for (account::Table& table : profile_tables(in)) blocks.emplace_back(std::move(table));
  if (!in.loads.empty()) blocks.emplace_back(load_table(in));
  if (!in.springs.empty()) blocks.emplace_back(spring_table(in));
  for (account::Table& table : tolerance_tables(in)) blocks.emplace_back(std::move(table));
  return blocks;
}

std::vector<account::Block> result_tables(const account::Account& account, const mechanism::Model& model,
                                          const mechanism::Structure& structure, const Cycle& cycle, const Axis* axis) {
  std::vector<account::Block> blocks{axis == nullptr ? position_table(account) : extremes_table(account, cycle, *axis)};
  if (axis != nullptr) {
    if (auto constant = constant_table(account, *axis)) blocks.emplace_back(std::move(*constant));
  }
  if (auto efficiency = efficiency_table(account, axis)) blocks.emplace_back(std::move(*efficiency));
  if (auto standing = standing_table(model, cycle, axis)) blocks.emplace_back(std::move(*standing));
  if (auto resting = dead_point_table(model, cycle, axis)) blocks.emplace_back(std::move(*resting));
  if (auto flanks = flank_table(account, model, axis)) blocks.emplace_back(std::move(*flanks));
  blocks.emplace_back(structure_table(model, !cycle.unique.empty()));
  blocks.emplace_back(determinacy_table(model, structure, cycle, axis));
  if (!cycle.unique.empty()) blocks.emplace_back(uniqueness_table(model, cycle));
  return blocks;
}

}  // namespace loadpath::planar
