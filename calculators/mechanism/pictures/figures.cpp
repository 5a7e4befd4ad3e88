#include "calculators/mechanism/pictures/figures.hpp"

#include "calculators/mechanism/pictures/animation.hpp"
#include "calculators/mechanism/pictures/hodographs.hpp"
#include "calculators/mechanism/pictures/plans.hpp"
#include "calculators/mechanism/pictures/scheme.hpp"
#include "calculators/mechanism/results/governing.hpp"
#include "calculators/mechanism/results/output.hpp"
#include "calculators/mechanism/words/points.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

const account::Entry* find_entry(const account::Account& account, const std::string& path) {
  const auto found =
      std::find_if(account.results.begin(), account.results.end(), [&](const auto& e) { return e.path == path; });
  return found == account.results.end() ? nullptr : &*found;
}

/// A cyclic series is drawn with its first point repeated at the end.
draw::Curve curve_of(const std::string& label, const Value& value) {
  const Axis& axis = *value.signature.axis;
  draw::Curve curve{label, axis.at, value.si, false};
  if (axis.cyclic()) {
    curve.x.push_back(axis.at.front() + axis.period);
    curve.y.push_back(value.si.front());
  }
  return curve;
}

draw::Scale scale_of(const Axis& axis) { return {axis_symbol(axis), axis.quantity, axis.unit}; }

draw::Figure drive_figure(const account::Entry& entry, const Axis& axis) {
  const bool rotary = entry.path == "drive.M";
  draw::Plot plot{scale_of(axis), {rotary ? "M" : "F", entry.doc, entry.unit}};
  plot.curves.push_back(curve_of(rotary ? "M" : "F", entry.value));
  const Extreme peak = largest(entry.value);
  if (!std::isnan(peak.value)) plot.marks.push_back({peak.at, peak.value, "peak"});
  const bool timed = axis.quantity == "time";
  const char* const moment = timed ? "Moment of the drive over time" : "Moment of the drive over the crank angle";
  const char* const force = timed ? "Force of the drive over time" : "Force of the drive over the stroke";
  return {rotary ? "drive" : "drive-" + entry.path, rotary ? moment : force, std::move(plot)};
}

draw::Figure reactions_figure(const mechanism::Model& model, const account::Account& account, const Axis& axis) {
  draw::Plot plot{scale_of(axis), {"R", "force of the joints", "N"}};
  for (const auto& j : model.joints) {
    if (plot.curves.size() == 6) break;  // more cannot be told apart
    if (const auto* e = find_entry(account, "joints." + j.name + ".F"))
      plot.curves.push_back(curve_of("R_" + j.name, e->value));
  }
  return {"reactions",
          axis.cyclic() ? "Forces in the joints over the cycle" : "Forces in the joints over the positions",
          std::move(plot)};
}

/// The positions that the user has asked for by their angles, where they are few enough for a page.
bool draws_each(const Mechanism::Input& in) { return in.crank.at.size() > 1 && in.crank.at.size() <= 12; }

}  // namespace

std::vector<draw::Figure> mechanism_figures(const Mechanism::Input& in, const mechanism::Model& model,
                                            const Cycle& cycle, const account::Account& account, const Axis* axis) {
  std::vector<draw::Figure> figures;
  const auto first = std::find(cycle.closed.begin(), cycle.closed.end(), true);
  if (first == cycle.closed.end()) return figures;
  const Extents extents = extents_of(model, cycle);
  const std::vector<TracedPoint> points = traced_points(in);
  const auto& start = cycle.positions[static_cast<std::size_t>(first - cycle.closed.begin())];
  draw::Scheme scheme = scheme_at(model, start, extents, points, Shown::at_rest).still;
  if (axis != nullptr) add_paths(points, cycle, axis->cyclic(), scheme);
  figures.push_back({"first-position",
                     "The mechanism at the first position, with the loads and, in each joint, the force of its first "
                     "link on the second",
                     std::move(scheme)});
  const std::size_t governing = axis == nullptr ? 0 : governing_position(cycle, account);
  const bool has_forces = governing < cycle.positions.size() && cycle.has_forces(governing);
  const bool statics = in.analysis == Mechanism::Analysis::statics;
  if (axis != nullptr && has_forces)
    figures.push_back(animation({model, cycle, extents, points, account, *axis, governing, statics}));
  if (has_forces) {
    const auto plans = plan_figures({model, points, cycle.positions[governing], statics});
    figures.insert(figures.end(), plans.begin(), plans.end());
  }
  if (axis == nullptr) return figures;
  for (std::size_t k = 1; k < cycle.positions.size() && draws_each(in); ++k) {
    if (!cycle.closed[k]) continue;
    figures.push_back({"position-" + std::to_string(k + 1),
                       "The mechanism at the given crank angle, with the same forces",
                       scheme_at(model, cycle.positions[k], extents, points, Shown::at_rest).still});
  }
  for (const auto& e : account.results) {
    if (is_drive_effort(e.path)) figures.push_back(drive_figure(e, *axis));
  }
  figures.push_back(reactions_figure(model, account, *axis));
  for (draw::Figure& figure : hodograph_figures(in, model, cycle, *axis)) figures.push_back(std::move(figure));
  return figures;
}

}  // namespace loadpath::planar
