#include "calculators/mechanism/planar_influence.hpp"

#include "lib/mechanism/causes.hpp"
#include "lib/mechanism/sensitivity.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath {

namespace {

using mechanism::Cause;
using mechanism::Parameter;
using mechanism::Position;
using report::Cell;
using report::Quantity;
using report::Table;

constexpr std::size_t most_columns = 7;
constexpr std::size_t most_parameters = 12;
constexpr double negligible = 1e-12;  // of the largest value of its kind

std::string load_name(const mechanism::Model& model, std::size_t load) {
  const std::string& name = model.loads[load].name;
  return name.empty() ? std::to_string(load + 1) : name;
}

Message name_of(const Cause& cause, const mechanism::Model& model) {
  switch (cause.kind) {
    case Cause::Kind::weights:
      return say("weights");
    case Cause::Kind::inertia:
      return say("inertia of {1}", model.links[cause.index].name);
    case Cause::Kind::load:
      return say("load {1}", load_name(model, cause.index));
    case Cause::Kind::spring:
      return say("spring {1}", model.springs[cause.index].name);
    case Cause::Kind::induced:
      return say("what joint {1} induces", model.joints[cause.index].name);
  }
  return say("weights");
}

/// Something that is split: an effort, or the force of a joint along its own direction.
struct Column {
  std::string title;
  const char* unit;
  std::size_t index;
  bool effort;
  mechanism::Vec along;
  double whole;

  [[nodiscard]] double of(const mechanism::Forces& forces) const {
    return effort ? forces.effort[index] : dot(forces.reactions[index].force, along);
  }
};

std::vector<Column> columns_of(const mechanism::Model& model, const Position& at) {
  std::vector<Column> columns;
  for (std::size_t d = 0; d < model.drivers.size(); ++d) {
    const bool rotary = model.drivers[d].kind == mechanism::Driver::Kind::rotary;
    columns.push_back({rotary ? "drive.M" : model.drivers[d].name, rotary ? "N*m" : "N", d, true, {}, at.effort[d]});
  }
  for (std::size_t k = 0; k < model.joints.size() && columns.size() < most_columns; ++k) {
    const mechanism::Vec force = at.reactions[k].force;
    const double size = mechanism::length(force);
    if (!(size > 0.0)) continue;
    columns.push_back({"joints." + model.joints[k].name + ".F", "N", k, false, (1.0 / size) * force, size});
  }
  return columns;
}

void add_causes(const mechanism::Model& model, const Position& at, bool statics, std::vector<Table>& tables) {
  mechanism::CauseSplit split(model);
  if (!split.find(at, statics)) return;
  const std::vector<Column> columns = columns_of(model, at);
  Table table{say("Causes of the forces at the governing position, along each force"), {say("cause")}, {}};
  for (const Column& column : columns) table.head.push_back(say("{1}", column.title));
  for (std::size_t c = 0; c < split.causes().size(); ++c) {
    std::vector<Cell> row{name_of(split.causes()[c], model)};
    bool any = false;
    for (const Column& column : columns) {
      const double share = column.of(split.share(c));
      const bool nothing = std::abs(share) <= negligible * std::abs(column.whole);
      any = any || !nothing;
      row.push_back(nothing ? Cell(std::string("–")) : Cell(Quantity{share, column.unit}));
    }
    if (any) table.rows.push_back(std::move(row));
  }
  std::vector<Cell> sum{say("together")};
  for (const Column& column : columns) sum.push_back(Quantity{column.whole, column.unit});
  table.rows.push_back(std::move(sum));
  tables.push_back(std::move(table));
}

std::string link_name(const mechanism::Model& model, int link) {
  return link == mechanism::ground ? "ground" : model.links[static_cast<std::size_t>(link)].name;
}

/// A parameter in words, and the step for which a change is shown: 0.1 mm, 0.1 degrees, or a hundredth of it.
struct Described {
  Message name;
  double step;
  Cell shown;
};

Described length_of(Message name) { return {std::move(name), 1e-4, Quantity{1e-4, "mm"}}; }
Described angle_of(Message name) { return {std::move(name), 0.1 * pi / 180.0, Quantity{0.1 * pi / 180.0, "deg"}}; }
Described part_of(Message name, double value) { return {std::move(name), 0.01 * value, say("1 %")}; }

Described describe(const Parameter& p, mechanism::Model& model) {
  using enum Parameter::Dimension;
  const double value = mechanism::number(model, p);
  const auto joint = [&]() -> const mechanism::Joint& { return model.joints[p.index]; };
  const auto link = [&] { return model.links[p.index].name; };
  const auto spring = [&] { return model.springs[p.index].name; };
  const auto load = [&] { return load_name(model, p.index); };
  switch (p.dimension) {
    case point_i_x:
      return length_of(say("{1} on {2}, x", joint().name, link_name(model, joint().i)));
    case point_i_y:
      return length_of(say("{1} on {2}, y", joint().name, link_name(model, joint().i)));
    case point_j_x:
      return length_of(say("{1} on {2}, x", joint().name, link_name(model, joint().j)));
    case point_j_y:
      return length_of(say("{1} on {2}, y", joint().name, link_name(model, joint().j)));
    case direction:
      return angle_of(say("direction of {1}", joint().name));
    case angle:
      return angle_of(say("angle held by {1}", joint().name));
    case radius_i:
    case radius_j:
      return length_of(
          say("radius of {1} on {2}", joint().name, link_name(model, p.dimension == radius_i ? joint().i : joint().j)));
    case pressure_angle:
      return angle_of(say("pressure angle of {1}", joint().name));
    case pin_radius:
      return length_of(say("pin radius of {1}", joint().name));
    case friction_coefficient:
      return part_of(say("friction of {1}", joint().name), value);
    case mass:
      return part_of(say("mass of {1}", link()), value);
    case inertia:
      return part_of(say("moment of inertia of {1}", link()), value);
    case centre_x:
      return length_of(say("mass centre of {1}, x", link()));
    case centre_y:
      return length_of(say("mass centre of {1}, y", link()));
    case offset:
      return model.drivers[p.index].kind == mechanism::Driver::Kind::linear
                 ? length_of(say("place of the drive {1}", model.drivers[p.index].name))
                 : angle_of(say("place of the drive {1}", model.drivers[p.index].name));
    case spring_i_x:
    case spring_i_y:
    case spring_j_x:
    case spring_j_y:
      return length_of(say("an end of spring {1}", spring()));
    case rate:
      return part_of(say("rate of {1}", spring()), value);
    case free:
      return model.springs[p.index].kind == mechanism::Spring::Kind::turning
                 ? angle_of(say("free angle of {1}", spring()))
                 : part_of(say("free length of {1}", spring()), value);
    case damping:
      return part_of(say("damping of {1}", spring()), value);
    case load_x:
    case load_y:
      return part_of(say("force of load {1}", load()), value);
    case load_moment:
      return part_of(say("couple of load {1}", load()), value);
    case load_at_x:
      return length_of(say("place of load {1}, x", load()));
    case load_at_y:
      return length_of(say("place of load {1}, y", load()));
  }
  return part_of(say("mass of {1}", link()), value);
}

struct Change {
  Described parameter;
  double by = 0.0;  // of the effort
};

std::vector<Change> changes_of(const mechanism::Model& model, const Position& at, bool statics) {
  mechanism::Sensitivity sensitivity(model);
  if (sensitivity.find(at, statics) != mechanism::Status::closed) return {};
  mechanism::Model numbers = model;
  for (std::size_t n = 0; n < numbers.loads.size(); ++n) {  // as they are at the position
    numbers.loads[n].force = at.loads[n].force;
    numbers.loads[n].moment = at.loads[n].moment;
  }
  std::vector<Change> changes;
  for (std::size_t k = 0; k < sensitivity.parameters().size(); ++k) {
    const Parameter::Dimension dimension = sensitivity.parameters()[k].dimension;
    if (dimension == Parameter::Dimension::load_y) continue;
    Described parameter = describe(sensitivity.parameters()[k], numbers);
    double by = sensitivity.by(k).effort[0] * parameter.step;
    if (dimension == Parameter::Dimension::load_x)  // a force changes along itself: with its y, which comes next
      by += sensitivity.by(k + 1).effort[0] * describe(sensitivity.parameters()[k + 1], numbers).step;
    if (std::abs(by) > 1e-9 * std::abs(at.effort[0])) changes.push_back({std::move(parameter), by});
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return std::abs(a.by) > std::abs(b.by); });
  if (changes.size() > most_parameters) changes.resize(most_parameters);
  return changes;
}

void add_changes(const mechanism::Model& model, const Position& at, bool statics, std::vector<Table>& tables) {
  if (model.drivers.empty() || at.effort[0] == 0.0) return;
  const bool rotary = model.drivers[0].kind == mechanism::Driver::Kind::rotary;
  Table table{say("What changes the effort of the drive most, at the governing position (exact derivatives)"),
              {say("dimension, mass or load"), say("changed by"), say("changes the effort by"), say("part of it")},
              {}};
  for (const Change& change : changes_of(model, at, statics)) {
    table.rows.push_back({change.parameter.name, change.parameter.shown, Quantity{change.by, rotary ? "N*m" : "N", 3},
                          Quantity{change.by / at.effort[0], "-", 2}});
  }
  if (!table.rows.empty()) tables.push_back(std::move(table));
}

}  // namespace

std::vector<Table> influence_tables(const mechanism::Model& model, const Cycle& cycle, std::size_t governing,
                                    bool statics) {
  std::vector<Table> tables;
  if (governing >= cycle.positions.size() || !cycle.has_forces(governing)) return tables;
  add_causes(model, cycle.positions[governing], statics, tables);
  // With other dimensions joints that hold too much would not close.
  if (cycle.unique.empty()) add_changes(model, cycle.positions[governing], statics, tables);
  return tables;
}

}  // namespace loadpath
