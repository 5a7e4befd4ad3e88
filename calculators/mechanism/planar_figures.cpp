#include "calculators/mechanism/planar_outputs.hpp"
#include "calculators/mechanism/planar_report.hpp"
#include "lib/mechanism/vec.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath {

namespace {

using draw::Scheme;
using mechanism::Position;
using mechanism::Vec;

draw::Point point(Vec v) { return {v.x, v.y}; }

Vec on_paper(const Position& p, int link, Vec at) { return motion_of(p, link, at).place; }

/// The points of a link that joints and loads use, each once, in the order of the joints.
std::vector<Vec> used_points(const mechanism::Model& model, int link) {
  std::vector<Vec> points;
  const auto add = [&](Vec at) {
    const bool known =
        std::any_of(points.begin(), points.end(), [&](Vec q) { return mechanism::length(q - at) == 0.0; });
    if (!known) points.push_back(at);
  };
  for (const auto& j : model.joints) {
    if (j.i == link) add(j.point_i);
    if (j.j == link && j.kind == mechanism::JointKind::revolute) add(j.point_j);
  }
  for (const auto& l : model.loads) {
    if (l.link == link && (l.force.x != 0.0 || l.force.y != 0.0)) add(l.point);
  }
  return points;
}

/// The line of a guide or slot, from its own point to the pin and a little beyond either.
Scheme::Guide guide_of(const mechanism::Joint& j, const Position& p) {
  const Vec start = on_paper(p, j.j, j.point_j), pin = on_paper(p, j.i, j.point_i);
  const double phi = (j.j == mechanism::ground ? 0.0 : p.pose[static_cast<std::size_t>(j.j)].phi) + j.direction;
  const Vec along{std::cos(phi), std::sin(phi)};
  const double reach = mechanism::dot(pin - start, along);
  const double margin = 0.2 * std::abs(reach);
  return {point(start + (std::min(0.0, reach) - margin) * along),
          point(start + (std::max(0.0, reach) + margin) * along), j.j == mechanism::ground};
}

/// What rounding leaves of a zero beside the largest reaction and its moment: not drawn.
struct Negligible {
  double force = 0.0, moment = 0.0;
};
Negligible negligible(const Position& p) {
  Negligible least;
  for (const auto& r : p.reactions) {
    const double force = 1e-12 * mechanism::length(r.force);
    least.force = std::max(least.force, force);
    least.moment = std::max(least.moment, force * mechanism::length(r.at));
  }
  return least;
}

Scheme scheme_at(const mechanism::Model& model, const Position& p) {
  const Negligible rounding = negligible(p);
  Scheme scheme;
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    Scheme::Body body{model.links[k].name, {}};
    for (const Vec at : used_points(model, static_cast<int>(k)))
      body.points.push_back(point(on_paper(p, static_cast<int>(k), at)));
    scheme.bodies.push_back(std::move(body));
  }
  for (std::size_t n = 0; n < model.joints.size(); ++n) {
    const mechanism::Joint& j = model.joints[n];
    const bool slides = j.kind != mechanism::JointKind::revolute;
    const double phi = j.j == mechanism::ground ? 0.0 : p.pose[static_cast<std::size_t>(j.j)].phi;
    const bool fixed = j.i == mechanism::ground || j.j == mechanism::ground;
    scheme.joints.push_back({j.name, point(on_paper(p, j.i, j.point_i)),
                             slides ? Scheme::Pin::slider : Scheme::Pin::revolute, fixed && !slides,
                             phi + j.direction});
    if (slides) scheme.guides.push_back(guide_of(j, p));
    const Vec force = -p.reactions[n].force;  // of the first link on the second
    if (mechanism::length(force) > rounding.force)
      scheme.arrows.push_back({point(p.reactions[n].at), point(force), "R_" + j.name, false});
  }
  for (const auto& l : model.loads) {
    const Vec force =
        l.turns_with_link ? mechanism::turn(p.pose[static_cast<std::size_t>(l.link)].phi)(l.force) : l.force;
    const Vec at = on_paper(p, l.link, l.point);
    if (mechanism::length(force) > 0.0)
      scheme.arrows.push_back({point(at), point(force), l.name.empty() ? "F" : l.name, true});
    if (l.moment != 0.0) scheme.moments.push_back({point(at), l.moment, l.name.empty() ? "M" : l.name});
  }
  for (std::size_t d = 0; d < model.drivers.size(); ++d) {
    if (model.drivers[d].kind != mechanism::Driver::Kind::rotary) continue;
    const auto joint = std::find_if(model.joints.begin(), model.joints.end(), [&](const auto& j) {
      return j.kind == mechanism::JointKind::revolute &&
             std::minmax(j.i, j.j) == std::minmax(model.drivers[d].i, model.drivers[d].j);
    });
    if (joint != model.joints.end() && std::abs(p.effort[d]) > rounding.moment)
      scheme.moments.push_back({point(on_paper(p, joint->i, joint->point_i)), p.effort[d], "M"});
  }
  return scheme;
}

/// Paths of the moving pins over a whole turn.
void add_paths(const mechanism::Model& model, const Cycle& cycle, Scheme& scheme) {
  for (const auto& j : model.joints) {
    if (j.i == mechanism::ground || j.j == mechanism::ground) continue;
    Scheme::Path path{j.name, {}};
    for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
      if (cycle.closed[k]) path.points.push_back(point(on_paper(cycle.positions[k], j.i, j.point_i)));
    }
    if (path.points.size() > 2 && std::all_of(cycle.closed.begin(), cycle.closed.end(), [](bool c) { return c; }))
      path.points.push_back(path.points.front());
    scheme.paths.push_back(std::move(path));
  }
}

const project::Entry* find_entry(const project::Account& account, const std::string& path) {
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

draw::Figure drive_figure(const project::Entry& entry, const Axis& axis) {
  const bool rotary = entry.path == "drive.M";
  draw::Plot plot{{"phi", axis.quantity, axis.unit}, {rotary ? "M" : "F", entry.doc, entry.unit}, {}, {}, {}};
  plot.curves.push_back(curve_of(rotary ? "M" : "F", entry.value));
  const Extreme peak = largest(entry.value);
  if (!std::isnan(peak.value)) plot.marks.push_back({peak.at, peak.value, "peak"});
  return {rotary ? "drive" : "drive-" + entry.path,
          rotary ? "Moment of the drive over the crank angle" : "Force of the drive over the stroke", std::move(plot)};
}

draw::Figure reactions_figure(const mechanism::Model& model, const project::Account& account, const Axis& axis) {
  draw::Plot plot{{"phi", axis.quantity, axis.unit}, {"R", "force of the joints", "N"}, {}, {}, {}};
  for (const auto& j : model.joints) {
    if (plot.curves.size() == 6) break;  // more cannot be told apart
    if (const auto* e = find_entry(account, "joints." + j.name + ".F"))
      plot.curves.push_back(curve_of("R_" + j.name, e->value));
  }
  return {"reactions", "Forces in the joints over the cycle", std::move(plot)};
}

/// The positions that the user has asked for by their angles, where they are few enough for a page.
bool draws_each(const PlanarMechanism::Input& in) { return in.crank.at.size() > 1 && in.crank.at.size() <= 12; }

draw::Figure figure_at(const mechanism::Model& model, const Cycle& cycle, std::size_t k) {
  return {"position-" + std::to_string(k + 1), "The mechanism at the given crank angle, with the same forces",
          scheme_at(model, cycle.positions[k])};
}

}  // namespace

std::vector<draw::Figure> mechanism_figures(const PlanarMechanism::Input& in, const mechanism::Model& model,
                                            const Cycle& cycle, const project::Account& account, const Axis* axis) {
  std::vector<draw::Figure> figures;
  const auto first = std::find(cycle.closed.begin(), cycle.closed.end(), true);
  if (first == cycle.closed.end()) return figures;
  Scheme start = scheme_at(model, cycle.positions[static_cast<std::size_t>(first - cycle.closed.begin())]);
  if (axis != nullptr) add_paths(model, cycle, start);
  figures.push_back({"first-position",
                     "The mechanism at the first position, with the loads and, in each joint, the force of its first "
                     "link on the second",
                     std::move(start)});
  if (axis == nullptr) return figures;
  for (std::size_t k = 1; k < cycle.positions.size() && draws_each(in); ++k) {
    if (cycle.closed[k]) figures.push_back(figure_at(model, cycle, k));
  }
  const project::Entry* drive = find_entry(account, "drive.M");
  if (drive != nullptr && !std::isnan(largest(drive->value).value)) {
    figures.push_back({"peak-position",
                       "The mechanism at the position nearest to the largest moment of the drive, with the same forces",
                       scheme_at(model, cycle.positions[largest(drive->value).nearest])});
  }
  for (const auto& e : account.results) {
    if (e.path == "drive.M" || e.path.starts_with("cylinders.")) figures.push_back(drive_figure(e, *axis));
  }
  figures.push_back(reactions_figure(model, account, *axis));
  return figures;
}

}  // namespace loadpath
