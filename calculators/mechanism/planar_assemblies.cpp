#include "calculators/mechanism/planar_assemblies.hpp"

#include "lib/mechanism/assemblies.hpp"
#include "lib/mechanism/closing.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <optional>

namespace loadpath {

namespace {

using mechanism::Assembly;

bool has(const Assembly& assembly, std::string_view side) {
  return std::find(assembly.sides.begin(), assembly.sides.end(), side) != assembly.sides.end();
}

std::vector<std::string> all_sides(const std::vector<Assembly>& list) {
  std::vector<std::string> sides;
  for (const Assembly& a : list) {
    for (const std::string& side : a.sides) {
      if (std::find(sides.begin(), sides.end(), side) == sides.end()) sides.push_back(side);
    }
  }
  return sides;
}

std::string listed(const std::vector<Assembly>& list) {
  std::string names;
  for (const Assembly& a : list) names += (names.empty() ? "" : "; ") + a.name();
  return names;
}

/// Of the assemblies with all the named sides, the one that keeps most of the stated ones.
const Assembly* best(const std::vector<Assembly>& list, const PlanarMechanism::Input& in) {
  const Assembly* chosen = nullptr;
  std::ptrdiff_t most = -1;
  for (const Assembly& a : list) {
    const bool fits =
        std::all_of(in.sides.begin(), in.sides.end(), [&](const auto& s) { return has(a, s.side.view()); });
    const auto kept =
        std::count_if(list[0].sides.begin(), list[0].sides.end(), [&](const auto& s) { return has(a, s); });
    if (!fits || kept <= most) continue;
    chosen = &a;
    most = kept;
  }
  return chosen;
}

/// Where a dyad goes through its change point, on the axis.
struct Change {
  std::string joint;
  double at = 0.0;
};

std::optional<double> passes(double before, double after, double from, double way) {
  if (before * after >= 0.0) return {};
  return from + way * before / (before - after);
}

std::vector<Change> changes(const mechanism::Model& model, const Cycle& cycle, const Axis& axis) {
  std::vector<Change> found;
  const std::size_t count = cycle.positions.size();
  for (const mechanism::DyadClosing& dyad : dyad_closings(model, plan_of(model))) {
    const auto sine = [&](std::size_t k) { return closing_angle(model, dyad, cycle.positions[k].pose).sine; };
    for (std::size_t k = 0; k < (axis.cyclic() ? count : count - 1); ++k) {
      const std::size_t next = (k + 1) % count;
      if (!cycle.closed[k] || !cycle.closed[next]) continue;
      const double way = axis.at[next] - axis.at[k] + (next == 0 ? axis.period : 0.0);
      if (const auto at = passes(sine(k), sine(next), axis.at[k], way))
        found.push_back({model.joints[dyad.joint].name, *at});
    }
  }
  return found;
}

}  // namespace

std::vector<FieldFault> choose_assembly(const PlanarMechanism::Input& in, mechanism::Model& model) {
  if (in.sides.empty()) return {};
  const auto list = mechanism::assemblies(model).list;
  const auto sides = all_sides(list);
  std::vector<FieldFault> faults;
  for (const auto& s : in.sides) {
    if (std::find(sides.begin(), sides.end(), s.side.view()) != sides.end()) continue;
    faults.push_back({"sides", say("no group has the side '{1}'", s.side.view()),
                      did_you_mean(s.side.view(), sides, there_is(sides))});
  }
  if (!faults.empty()) return faults;
  const Assembly* chosen = best(list, in);
  if (chosen == nullptr) return {{"sides", say("no assembly has all these sides"), say("there is: {1}", listed(list))}};
  for (std::size_t k = 0; k < model.links.size(); ++k) model.links[k].pose = chosen->poses[k];
  return {};
}

std::vector<report::Verdict> changes_of_assembly(const std::string& step, const mechanism::Model& model,
                                                 const Cycle& cycle, const Axis* axis) {
  if (axis == nullptr) return {};
  const auto found = changes(model, cycle, *axis);
  if (found.empty()) return {};
  std::string places;
  for (const Change& c : found)
    places += (places.empty() ? "" : ", ") + say("{1} at {2}", c.joint, format_quantity(c.at, axis->unit, 4)).text();
  report::Verdict v;
  v.step = step;
  v.symbol = "assembly";
  v.meaning = say("every dyad stays on its side");
  v.bound = say("no change point");
  v.value = say("passed {1} times", std::to_string(found.size()));
  v.state = report::State::not_covered;
  v.note = say("the drive alone does not tell which way the mechanism goes on: {1}", places);
  return {v};
}

}  // namespace loadpath
