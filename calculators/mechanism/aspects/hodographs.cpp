// Hodographs of joint forces: the end of the force over the cycle, on either part and in fixed axes.
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/model/frames.hpp"
#include "lib/numerics/magnitude.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

using figure::Plan;
using mechanism::Position;
using mechanism::Vec;

constexpr std::size_t busiest = 3;
constexpr double mark_spacing = pi / 6.0;
constexpr std::size_t marks_of_other_axes = 12;

/// A joint with its forces over the cycle.
struct Loaded {
  std::size_t joint = 0;
  double most = 0.0;  // N
  std::size_t governing = 0;
};

Loaded loaded(const Cycle& cycle, std::size_t joint) {
  Loaded l{joint};
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (!cycle.has_forces(k)) continue;
    const double size = mechanism::length(cycle.positions[k].reactions[joint].force);
    if (numerics::exceeds(size, l.most)) l.most = size, l.governing = k;
  }
  return l;
}

std::vector<Loaded> chosen(const Mechanism::Input& in, const mechanism::Model& model, const Cycle& cycle) {
  std::vector<Loaded> all;
  for (const planar::Hodograph& h : in.hodographs) {
    all.push_back(loaded(cycle, index_of(in.joints, h.joint)));
  }
  if (all.empty()) {
    for (std::size_t k = 0; k < model.joints.size(); ++k) {
      if (model.joints[k].kind == mechanism::JointKind::revolute) all.push_back(loaded(cycle, k));
    }
    std::stable_sort(all.begin(), all.end(), [](const Loaded& a, const Loaded& b) { return a.most > b.most; });
    if (all.size() > busiest) all.resize(busiest);
  }
  std::erase_if(all, [](const Loaded& l) { return l.most == 0.0; });
  return all;
}

/// Positions that have a mark: the nearest to every 30 degrees of the crank; of other axes a dozen.
std::vector<std::size_t> marked(const Axis& axis) {
  std::vector<std::size_t> places;
  if (axis.unit != "deg") {
    const std::size_t spacing = std::max<std::size_t>(1, axis.at.size() / marks_of_other_axes);
    for (std::size_t k = 0; k < axis.at.size(); k += spacing) places.push_back(k);
    return places;
  }
  const double half = axis.at.size() > 1 ? 0.5 * std::abs(axis.at[1] - axis.at[0]) : 0.0;
  for (std::size_t k = 0; k < axis.at.size(); ++k) {
    const double off = std::abs(std::remainder(axis.at[k], mark_spacing));
    if (off <= half * (1.0 - 1e-9) || off < 1e-9) places.push_back(k);
  }
  return places;
}

class Drawing {
 public:
  Drawing(const mechanism::Model& model, const Cycle& cycle, const Axis& axis, const Loaded& of)
      : model_(model), cycle_(cycle), axis_(axis), of_(of), joint_(model.joints[of.joint]) {}

  [[nodiscard]] figure::Figure figure() const {
    const std::string first = link_name(model_, joint_.i), second = link_name(model_, joint_.j);
    figure::Plans plans;
    for (const int link : {joint_.j, joint_.i}) {
      if (link == mechanism::ground) continue;
      plans.panels.push_back(
          panel(say("{1}: {2} on {3}, in the axes of {4}", joint_.name, first, second, link_name(model_, link)), link));
    }
    plans.panels.push_back(panel(say("{1}: {2} on {3}, in fixed axes", joint_.name, first, second), mechanism::ground));
    return {"hodograph-" + joint_.name,
            axis_.cyclic() ? "Hodograph of the joint force in link and fixed coordinates; arrow: maximum"
                           : "The end of a joint's force over the positions, seen from either part and in fixed axes; "
                             "the arrow is its maximum",
            std::move(plans)};
  }

 private:
  /// The force of the first link on the second.
  [[nodiscard]] figure::Point force(std::size_t k, int link) const {
    const Position& at = cycle_.positions[k];
    const Vec f = mechanism::placed_at(at, link).turned.back()(-at.reactions[of_.joint].force);
    return {f.x, f.y};
  }

  [[nodiscard]] Plan panel(const Message& title, int link) const {
    Plan plan;
    plan.title = title.text();
    plan.unit = N.symbol;
    Plan::Trace trace;
    for (std::size_t k = 0; k < cycle_.positions.size(); ++k) {
      if (cycle_.has_forces(k)) trace.points.push_back(force(k, link));
    }
    const bool whole = trace.points.size() == cycle_.positions.size();
    if (axis_.cyclic() && whole && !trace.points.empty()) trace.points.push_back(trace.points.front());
    for (const std::size_t k : marked(axis_)) {
      if (cycle_.has_forces(k) && k != of_.governing) trace.marks.push_back({force(k, link), place(k), false});
    }
    trace.marks.push_back({force(of_.governing, link), place(of_.governing), true});
    plan.vectors.push_back({{}, force(of_.governing, link), "R_" + joint_.name, Plan::Tone::first});
    plan.traces.push_back(std::move(trace));
    return plan;
  }

  [[nodiscard]] std::string place(std::size_t k) const { return format_quantity(axis_.at[k], axis_.unit, 4); }

  const mechanism::Model& model_;
  const Cycle& cycle_;
  const Axis& axis_;
  const Loaded& of_;
  const mechanism::Joint& joint_;
};

/// Joints that do not exist or are named twice.
void check_names_of_hodographs(NameFaults& faults) {
  const auto& wanted = faults.input().hodographs;
  for (std::size_t n = 0; n < wanted.size(); ++n) {
    const std::string path = "hodographs[" + std::to_string(n + 1) + "]";
    if (!faults.require_joint(wanted[n].joint, path)) continue;
    const bool again = std::any_of(wanted.begin(), wanted.begin() + static_cast<std::ptrdiff_t>(n),
                                   [&](const auto& other) { return other.joint == wanted[n].joint; });
    if (again) faults.add(path, say("the joint '{1}' is named twice", wanted[n].joint.view()), say("leave one out"));
  }
}

/// Notes on named joints without a hodograph.
void show_hodographs(const Solved& solved, const Results&, std::vector<account::Block>& blocks) {
  const Cycle& cycle = solved.cycle;
  const auto add = [&](Message text) {
    blocks.emplace_back(account::Paragraph{std::move(text), account::Paragraph::Tone::note});
  };
  if (solved.axis == nullptr && !solved.in.hodographs.empty())
    add(say("No hodographs: they need more than one position."));
  if (solved.axis == nullptr) return;
  for (const planar::Hodograph& wanted : solved.in.hodographs) {
    const std::size_t joint = index_of(solved.in.joints, wanted.joint);
    if (loaded(cycle, joint).most > 0.0) continue;
    const bool unique = cycle.unique.empty() || cycle.unique[joint].force;
    add(unique ? say("No hodograph of '{1}': it has no force at any position.", wanted.joint.view())
               : say("No hodograph of '{1}': its force is not unique.", wanted.joint.view()));
  }
}

/// Hodographs of the joints that the project names, else of the three pins with the largest forces. A joint without a
/// force, or whose force is not unique, has none.
void draw_all(const Solved& solved, const Results&, std::vector<figure::Figure>& figures) {
  if (solved.axis == nullptr) return;
  for (const Loaded& l : chosen(solved.in, solved.given, solved.cycle))
    figures.push_back(Drawing(solved.given, solved.cycle, *solved.axis, l).figure());
}

}  // namespace

constinit const Aspect aspects::hodographs{
    .check_names = &check_names_of_hodographs, .show = &show_hodographs, .draw = &draw_all};

}  // namespace loadpath::planar
