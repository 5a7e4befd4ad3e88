// Dependence of the forces of a mechanism at its governing position: causes and parameters.
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/governing.hpp"
#include "lib/mechanism/accuracy/sensitivity.hpp"
#include "lib/mechanism/studies/causes.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::planar {

namespace {

using mechanism::Cause;
using mechanism::Parameter;
using Of = mechanism::Parameter::Dimension;
using account::Cell;
using account::Quantity;
using account::Table;
using mechanism::Position;

constexpr std::size_t most_columns = 7;
constexpr std::size_t most_parameters = 12;
constexpr double negligible = 1e-12;  // share of the largest value of its kind

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
      return say("friction or tooth and belt forces of joint {1}", model.joints[cause.index].name);
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
  Table table{say("Contributions to the joint forces at the governing position"), {say("cause")}, {}};
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

/// Unit of a parameter, with the step for which a change is shown: 0.1 mm, 0.1 degrees, or a hundredth.
enum class Measure { length, angle, part };

/// {1} is what the parameter belongs to, {2} the link that a joint's point or wheel is on.
struct Wording {
  Parameter::Dimension dimension;
  const char* id;
  Measure measure;
};

constexpr std::array wordings{Wording{Of::point_i_x, "{1} on {2}, x", Measure::length},
                              Wording{Of::point_i_y, "{1} on {2}, y", Measure::length},
                              Wording{Of::point_j_x, "{1} on {2}, x", Measure::length},
                              Wording{Of::point_j_y, "{1} on {2}, y", Measure::length},
                              Wording{Of::direction, "direction of {1}", Measure::angle},
                              Wording{Of::angle, "angle held by {1}", Measure::angle},
                              Wording{Of::radius_i, "radius of {1} on {2}", Measure::length},
                              Wording{Of::radius_j, "radius of {1} on {2}", Measure::length},
                              Wording{Of::pressure_angle, "pressure angle of {1}", Measure::angle},
                              Wording{Of::pin_radius, "pin radius of {1}", Measure::length},
                              Wording{Of::friction_coefficient, "friction of {1}", Measure::part},
                              Wording{Of::mass, "mass of {1}", Measure::part},
                              Wording{Of::inertia, "moment of inertia of {1}", Measure::part},
                              Wording{Of::centre_x, "mass centre of {1}, x", Measure::length},
                              Wording{Of::centre_y, "mass centre of {1}, y", Measure::length},
                              Wording{Of::offset, "position of the drive {1}", Measure::angle},
                              Wording{Of::spring_i_x, "an end of spring {1}", Measure::length},
                              Wording{Of::spring_i_y, "an end of spring {1}", Measure::length},
                              Wording{Of::spring_j_x, "an end of spring {1}", Measure::length},
                              Wording{Of::spring_j_y, "an end of spring {1}", Measure::length},
                              Wording{Of::rate, "rate of {1}", Measure::part},
                              Wording{Of::free, "free length of {1}", Measure::part},
                              Wording{Of::damping, "damping of {1}", Measure::part},
                              Wording{Of::load_x, "force of load {1}", Measure::part},
                              Wording{Of::load_y, "force of load {1}", Measure::part},
                              Wording{Of::load_moment, "couple of load {1}", Measure::part},
                              Wording{Of::load_at_x, "position of load {1}, x", Measure::length},
                              Wording{Of::load_at_y, "position of load {1}, y", Measure::length}};

/// That of the kind at hand, where kinds differ.
Wording wording_of(const Parameter& p, const mechanism::Model& model) {
  if (p.dimension == Of::offset && model.drivers[p.index].kind == mechanism::Driver::Kind::linear)
    return {p.dimension, "position of the drive {1}", Measure::length};
  if (p.dimension == Of::free && model.springs[p.index].kind == mechanism::Spring::Kind::turning)
    return {p.dimension, "free angle of {1}", Measure::angle};
  return *std::find_if(wordings.begin(), wordings.end(), [&](const Wording& w) { return w.dimension == p.dimension; });
}

Message name_of(const Parameter& p, const char* id, const mechanism::Model& model) {
  using enum Parameter::Dimension;
  if (p.dimension <= friction_coefficient) {
    const mechanism::Joint& joint = model.joints[p.index];
    const bool second = p.dimension == point_j_x || p.dimension == point_j_y || p.dimension == radius_j;
    return say(id, joint.name, link_name(model, second ? joint.j : joint.i));
  }
  if (p.dimension <= centre_y) return say(id, model.links[p.index].name);
  if (p.dimension == offset) return say(id, model.drivers[p.index].name);
  if (p.dimension <= damping) return say(id, model.springs[p.index].name);
  return say(id, load_name(model, p.index));
}

/// A parameter in words, and the step for which a change is shown.
struct Described {
  Message name;
  double step;
  Cell shown;
};

Described describe(const Parameter& p, mechanism::Model& model) {
  const auto [dimension, id, measure] = wording_of(p, model);
  Message name = name_of(p, id, model);
  if (measure == Measure::part) return {std::move(name), 0.01 * mechanism::number(model, p), say("1 %")};
  const double step = measure == Measure::length ? 0.1e-3 : 0.1 * pi / 180.0;
  return {std::move(name), step, Quantity{step, measure == Measure::length ? "mm" : "deg"}};
}

struct Change {
  Described parameter;
  double by = 0.0;  // change of the effort
};

double size_of(const Change& change) { return numerics::nine_digits(std::abs(change.by)); }

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
                   [](const Change& a, const Change& b) { return size_of(a) > size_of(b); });
  if (changes.size() > most_parameters) changes.resize(most_parameters);
  return changes;
}

void add_changes(const mechanism::Model& model, const Position& at, bool statics, std::vector<Table>& tables) {
  if (model.drivers.empty() || at.effort[0] == 0.0) return;
  const bool rotary = model.drivers[0].kind == mechanism::Driver::Kind::rotary;
  Table table{say("Sensitivity of the driving torque or force at the governing position (exact derivatives)"),
              {say("dimension, mass or load"), say("changed by"), say("changes the effort by"), say("part of it")},
              {}};
  for (const Change& change : changes_of(model, at, statics)) {
    table.rows.push_back({change.parameter.name, change.parameter.shown, Quantity{change.by, rotary ? "N*m" : "N", 3},
                          Quantity{change.by / at.effort[0], "-", 2}});
  }
  if (!table.rows.empty()) tables.push_back(std::move(table));
}

/// Every reaction and effort split by cause, and the change of the drive by the dimensions and masses that change it
/// most. None where the position has no forces.
void show_influence(const Solved& solved, const Results& results, std::vector<account::Block>& blocks) {
  const Cycle& cycle = solved.cycle;
  const std::size_t governing = governing_position(cycle, results);
  if (governing >= cycle.positions.size() || !cycle.has_forces(governing)) return;
  const bool statics = leaves_out_inertia(solved.in);
  std::vector<Table> tables;
  add_causes(solved.model, cycle.positions[governing], statics, tables);
  // With other dimensions joints that hold too much would not close.
  if (cycle.unique.empty()) add_changes(solved.model, cycle.positions[governing], statics, tables);
  append(std::move(tables), blocks);
}

}  // namespace

constinit const Aspect aspects::influence{.show = &show_influence};

}  // namespace loadpath::planar
