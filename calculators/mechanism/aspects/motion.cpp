// Motion in the report: assemblies at the first position, transmission angles, strokes, instantaneous centres at the
// first position.
#include "calculators/mechanism/cycle/rounding.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/groups/assemblies.hpp"
#include "lib/mechanism/groups/closing.hpp"
#include "lib/mechanism/studies/instant_centres.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

using account::Cell;
using account::Quantity;
using account::Table;
using mechanism::InstantCentre;
using mechanism::Reversal;
using mechanism::Stroke;

// multibodysystemsdynamics.pages.dev, glossary: 40 degrees in general machinery, 30 where loads are light.
constexpr double least_gamma = 40.0 * pi / 180.0, least_gamma_light = 30.0 * pi / 180.0;
constexpr std::size_t most_rows = 16;

mechanism::Model at_position(mechanism::Model model, const mechanism::Position& p) {
  for (std::size_t k = 0; k < model.links.size(); ++k) model.links[k].pose = p.pose[k];
  return model;
}

void add_assemblies(const mechanism::Model& model, std::vector<account::Block>& blocks) {
  const auto found = mechanism::assemblies(model);
  if (found.list.size() < 2) return;
  Table table{found.complete ? say("Assembly modes at the first position")
                             : say("Assemblies found at the first position; there may be more"),
              {say("assembly"), say("followed")},
              {}};
  for (std::size_t k = 0; k < std::min(found.list.size(), most_rows); ++k) {
    const auto& a = found.list[k];
    table.rows.push_back({a.name(), a.followed ? Cell(say("yes")) : Cell(std::string("–"))});
  }
  blocks.emplace_back(std::move(table));
}

Message side_meaning(const mechanism::Model& model, const mechanism::DyadClosing& dyad) {
  using Kind = mechanism::DyadClosing::Kind;
  const auto name = [&](std::size_t joint) { return model.joints[joint].name; };
  if (dyad.kind == Kind::two_arms) return say("left: of the line from {1} to {2}", name(dyad.first), name(dyad.second));
  if (dyad.kind == Kind::arm_and_line) return say("ahead: of {1} along {2}", name(dyad.first), name(dyad.line));
  return dyad.first == dyad.joint ? say("ahead: of {1} along the slot", name(dyad.second))
                                  : say("ahead: {1} of {2} along the guide", name(dyad.first), name(dyad.second));
}

Cell remark(double gamma) {
  if (gamma >= least_gamma) return std::string("–");
  return gamma >= least_gamma_light ? say("below 40°: light loads only") : say("below 30°");
}

/// Teeth press at the same angle at every position.
void add_teeth(const mechanism::Model& model, const Axis* axis, Table& table) {
  for (const mechanism::Joint& joint : model.joints) {
    if (joint.kind != mechanism::JointKind::gear && joint.kind != mechanism::JointKind::rack) continue;
    const std::string pressure = format_quantity(joint.pressure_angle, "deg", 4);
    std::vector<Cell> row{joint.name, say("teeth, pressure angle {1}", pressure),
                          Quantity{0.5 * pi - joint.pressure_angle, "deg"}};
    if (axis != nullptr) row.emplace_back(std::string("–"));
    row.emplace_back(std::string("–"));
    table.rows.push_back(std::move(row));
  }
}

/// The largest pressure angle of a cam leaves the smallest of transmission.
void add_cams(const Results& results, const Axis* axis, Table& table) {
  for (const auto& line : results) {
    if (line.kind() != Kind::pressure_angle) continue;
    const Extreme most = maximum(line.entry->value);
    std::vector<Cell> row{line.output->name, say("cam, pressure angle {1}", format_quantity(most.value, "deg", 4)),
                          Quantity{0.5 * pi - most.value, "deg"}};
    if (axis != nullptr) row.emplace_back(Quantity{most.at, axis->unit});
    row.push_back(remark(0.5 * pi - most.value));
    table.rows.push_back(std::move(row));
  }
}

void add_transmission(const mechanism::Model& model, const Results& results, const Axis* axis,
                      std::vector<account::Block>& blocks) {
  Table table{say("Transmission angles"), {say("joint"), say("side"), say("smallest"), say("at"), say("remark")}, {}};
  if (axis == nullptr) table.head.erase(table.head.begin() + 3);
  for (const mechanism::DyadClosing& dyad : dyad_closings(model, plan_of(model))) {
    const std::string& joint = model.joints[dyad.joint].name;
    const account::Entry* const gamma = results.find(Kind::transmission_angle, joint);
    const Extreme least = gamma == nullptr ? Extreme{} : minimum(gamma->value);
    std::vector<Cell> row{joint, side_meaning(model, dyad), Quantity{least.value, "deg"}};
    if (axis != nullptr) row.emplace_back(Quantity{least.at, axis->unit});
    row.push_back(remark(least.value));
    table.rows.push_back(std::move(row));
  }
  add_teeth(model, axis, table);
  add_cams(results, axis, table);
  if (!table.rows.empty()) blocks.emplace_back(std::move(table));
}

/// Values up to `least` are zero but for rounding, and shown as zero.
double settled(double x, double least) { return std::abs(x) <= least ? 0.0 : x; }

void add_strokes(const mechanism::Model& model, const Kinematics& kinematics, const Axis* axis,
                 std::vector<account::Block>& blocks) {
  Table table{say("Strokes and dead centres"),
              {say("part"), say("extreme"), say("at"), say("extreme"), say("at"), say("stroke"), say("time ratio")},
              {}};
  const double step = axis->at.size() > 1 ? std::abs(axis->at[1] - axis->at[0]) : 0.0;
  const auto place = [&](const Reversal& r) { return Quantity{settled(r.drive, 1e-6 * step), axis->unit}; };
  for (const Stroke& s : kinematics.strokes) {
    if (s.reversals.size() < 2) continue;
    const bool link = s.of == Stroke::Of::link;
    const char* unit = link ? "deg" : "mm";
    const auto extreme = [&](const Reversal& r) { return Quantity{settled(r.coordinate, 1e-12 * s.range), unit}; };
    const auto [low, high] = std::minmax_element(s.reversals.begin(), s.reversals.end(),
                                                 [](auto& a, auto& b) { return a.coordinate < b.coordinate; });
    table.rows.push_back({link ? model.links[s.index].name : model.joints[s.index].name, extreme(*low), place(*low),
                          extreme(*high), place(*high), Quantity{s.range, unit},
                          s.time_ratio > 0.0 ? Cell(Quantity{s.time_ratio, "-"}) : Cell(std::string("–"))});
  }
  if (!table.rows.empty()) blocks.emplace_back(std::move(table));
}

/// `size`: of the mechanism; compared with it and the other coordinate a rounded zero is shown as zero.
std::vector<Cell> cells_of(const InstantCentre& centre, double size) {
  const Cell nothing = std::string("–");
  if (centre.kind == InstantCentre::Kind::at_rest) return {say("at rest"), nothing};
  if (centre.kind == InstantCentre::Kind::point) {
    const double least = 1e-12 * std::max(size, mechanism::length(centre.at));
    return {Quantity{settled(centre.at.x, least), "mm"}, Quantity{settled(centre.at.y, least), "mm"}};
  }
  double direction = direction_of(centre.direction);  // towards either end
  if (direction < 0.0) direction += pi;
  if (direction == pi) direction = 0.0;
  return {say("at infinity, towards {1}", format_quantity(direction, "deg", 5)), nothing};
}

/// Centres of every two links if they are few, else against the ground.
void add_centres(const mechanism::Model& model, const mechanism::Position& derivatives,
                 std::vector<account::Block>& blocks) {
  constexpr std::size_t few_links = 3;
  Table table{
      say("Instantaneous centres at the first position"), {say("link"), say("against"), say("x"), say("y")}, {}};
  const double size = mechanism::characteristic_length(model);
  for (const auto& pair : instant_centres(derivatives, size)) {
    if (pair.j != mechanism::ground && model.links.size() > few_links) continue;
    std::vector<Cell> row{link_name(model, pair.i), link_name(model, pair.j)};
    for (Cell& cell : cells_of(pair.centre, size)) row.push_back(std::move(cell));
    table.rows.push_back(std::move(row));
  }
  blocks.emplace_back(std::move(table));
}

void show_motion(const Solved& solved, const Results& results, std::vector<account::Block>& blocks) {
  const Cycle& cycle = solved.cycle;
  const Kinematics& kinematics = solved.kinematics;
  const auto closed = std::find(cycle.closed.begin(), cycle.closed.end(), true);
  if (closed == cycle.closed.end()) return;
  const auto first = static_cast<std::size_t>(closed - cycle.closed.begin());
  if (cycle.unique.empty()) {  // else what was released would be taken for what the mechanism can do
    add_assemblies(at_position(solved.model, cycle.positions[first]), blocks);
    add_transmission(solved.model, results, solved.axis, blocks);
  }
  if (solved.axis != nullptr) add_strokes(solved.model, kinematics, solved.axis, blocks);
  if (first < kinematics.known.size() && kinematics.known[first])
    add_centres(solved.model, kinematics.derivatives[first], blocks);
}

}  // namespace

constinit const Aspect aspects::motion{.show = &show_motion};

}  // namespace loadpath::planar
