// The figures of a mechanism: at the first position, at each of up to 12 given angles, and where the drive is largest,
// as a drawing that moves and with its plans; drive and reactions over the cycle.
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/pictures/animation.hpp"
#include "calculators/mechanism/pictures/plans.hpp"
#include "calculators/mechanism/pictures/scheme.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/governing.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

/// A cyclic series is drawn with its first point repeated at the end.
figure::Curve curve_of(const std::string& label, const Value& value) {
  const Axis& axis = *value.signature.axis;
  figure::Curve curve{label, axis.at.values(), value.si, false};
  if (axis.cyclic()) {
    curve.x.push_back(axis.at.front() + axis.period);
    curve.y.push_back(value.si.front());
  }
  return curve;
}

figure::Scale scale_of(const Axis& axis) { return {axis_symbol(axis), axis.quantity, axis.unit}; }

figure::Figure drive_figure(const Results::Line& line, const Axis& axis) {
  const account::Entry& entry = *line.entry;
  const bool rotary = line.kind() == Kind::drive_moment;
  figure::Plot plot{scale_of(axis), {rotary ? "M" : "F", entry.doc, entry.unit}};
  plot.curves.push_back(curve_of(rotary ? "M" : "F", entry.value));
  const Extreme peak = largest(entry.value);
  if (!std::isnan(peak.value)) plot.marks.push_back({peak.at, peak.value, "peak"});
  const bool timed = axis.quantity == "time";
  const char* const moment = timed ? "Driving torque over time" : "Driving torque over the crank angle";
  const char* const force = timed ? "Force of the drive over time" : "Force of the drive over the stroke";
  return {rotary ? "drive" : "drive-" + entry.path, rotary ? moment : force, std::move(plot)};
}

figure::Figure reactions_figure(const Results& results, const Axis& axis) {
  figure::Plot plot{scale_of(axis), {"R", "force of the joints", "N"}};
  for (const auto& line : results) {
    if (plot.curves.size() == 6) break;  // more cannot be distinguished
    if (line.kind() == Kind::joint_force) plot.curves.push_back(curve_of("R_" + line.output->name, line.entry->value));
  }
  return {"reactions",
          axis.cyclic() ? "Forces in the joints over the cycle" : "Forces in the joints over the positions",
          std::move(plot)};
}

/// The positions requested by their angles, if they are few enough for a page.
bool draws_each(const Mechanism::Input& in) { return in.crank.at.size() > 1 && in.crank.at.size() <= 12; }

/// With the loads and, in each joint, the force of its first link on its second.
figure::Scheme first_position(const Solved& solved, std::size_t first, const Extents& extents,
                              const std::vector<TracedPoint>& points) {
  figure::Scheme scheme = scheme_at(solved.given, solved.cycle.positions[first], extents, points, Shown::at_rest).still;
  if (solved.axis != nullptr) add_paths(points, solved.cycle, solved.axis->cyclic(), scheme);
  return scheme;
}

void add_governing(const Solved& solved, const Results& results, const Extents& extents,
                   const std::vector<TracedPoint>& points, std::vector<figure::Figure>& figures) {
  const Cycle& cycle = solved.cycle;
  const std::size_t governing = solved.axis == nullptr ? 0 : governing_position(cycle, results);
  if (governing >= cycle.positions.size() || !cycle.has_forces(governing)) return;
  const bool statics = leaves_out_inertia(solved.in);
  if (solved.axis != nullptr)
    figures.push_back(animation({solved.given, cycle, extents, points, results, *solved.axis, governing, statics}));
  for (figure::Figure& plan : plan_figures({solved.given, points, cycle.positions[governing], statics}))
    figures.push_back(std::move(plan));
}

void draw_all(const Solved& solved, const Results& results, std::vector<figure::Figure>& figures) {
  const Cycle& cycle = solved.cycle;
  const auto first = std::find(cycle.closed.begin(), cycle.closed.end(), true);
  if (first == cycle.closed.end()) return;
  const Extents extents = extents_of(solved.given, cycle);
  const std::vector<TracedPoint> points = traced_points(solved.in);
  figures.push_back({"first-position",
                     "The mechanism at the first position, with the loads and, in each joint, the force of its first "
                     "link on the second",
                     first_position(solved, static_cast<std::size_t>(first - cycle.closed.begin()), extents, points)});
  add_governing(solved, results, extents, points, figures);
  if (solved.axis == nullptr) return;
  for (std::size_t k = 1; k < cycle.positions.size() && draws_each(solved.in); ++k) {
    if (!cycle.closed[k]) continue;
    figures.push_back({"position-" + std::to_string(k + 1),
                       "The mechanism at the given crank angle, with the same forces",
                       scheme_at(solved.given, cycle.positions[k], extents, points, Shown::at_rest).still});
  }
  for (const auto& line : results) {
    if (is_effort(line.kind())) figures.push_back(drive_figure(line, *solved.axis));
  }
  figures.push_back(reactions_figure(results, *solved.axis));
}

}  // namespace

constinit const Aspect aspects::figures{.draw = &draw_all};

}  // namespace loadpath::planar
