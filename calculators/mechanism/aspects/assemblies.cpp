#include "calculators/mechanism/aspects/assemblies.hpp"

#include "lib/mechanism/groups/assemblies.hpp"
#include "lib/mechanism/groups/closing.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <string_view>

namespace loadpath::planar {

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
const Assembly* best(const std::vector<Assembly>& list, const Mechanism::Input& in) {
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

/// The intervals between positions: from, to, and the way of the axis between them.
template <class See>
void for_each_interval(const Cycle& cycle, const Axis& axis, See see) {
  const std::size_t count = cycle.positions.size();
  for (std::size_t k = 0; k < (axis.cyclic() ? count : count - 1); ++k) {
    const std::size_t next = (k + 1) % count;
    if (!cycle.closed[k] || !cycle.closed[next]) continue;
    see(k, next, axis.at[next] - axis.at[k] + (next == 0 ? axis.period : 0.0));
  }
}

std::string place(double at, const Axis& axis) { return format_quantity(at, axis.unit, 4); }

/// Where dyads go through their change points: the sine of the closing angle through zero.
void add_dyads(const mechanism::Model& model, const Cycle& cycle, const Axis& axis, std::vector<Message>& found) {
  for (const mechanism::DyadClosing& dyad : dyad_closings(model, plan_of(model))) {
    const auto sine = [&](std::size_t k) { return closing_angle(model, dyad, cycle.positions[k].pose).sine; };
    for_each_interval(cycle, axis, [&](std::size_t k, std::size_t next, double way) {
      const double before = sine(k), after = sine(next);
      if (before * after >= 0.0) return;
      const double at = axis.at[k] + way * before / (before - after);
      found.push_back(say("{1} at {2}", model.joints[dyad.joint].name, place(at, axis)));
    });
  }
}

void add_iterated(const mechanism::Model& model, const Cycle& cycle, const Kinematics& kinematics, const Axis& axis,
                  std::vector<Message>& found) {
  for (const Kinematics::Iterated& group : kinematics.iterated) {
    for_each_interval(cycle, axis, [&](std::size_t k, std::size_t next, double way) {
      if (group.signs[k] * group.signs[next] >= 0.0) return;
      found.push_back(say("{1} between {2} and {3}", model.links[group.link].name, place(axis.at[k], axis),
                          place(axis.at[k] + way, axis)));
    });
  }
}

}  // namespace

std::vector<FieldFault> choose_assembly(const Mechanism::Input& in, const mechanism::Structure& structure,
                                        mechanism::Model& model) {
  if (in.sides.empty()) return {};
  if (!structure.redundant.empty())
    return {{"sides",
             say("sides do not tell the assembly where joints hold too much: {1}",
                 names_of(model.joints, structure.redundant[0])),
             say("state the rough place and angle of the links, or draw them")}};
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

std::vector<account::Verdict> changes_of_assembly(const std::string& step, const mechanism::Model& model,
                                                  const Cycle& cycle, const Kinematics& kinematics, const Axis* axis) {
  if (axis == nullptr || !cycle.unique.empty()) return {};
  std::vector<Message> found;
  add_dyads(model, cycle, *axis, found);
  add_iterated(model, cycle, kinematics, *axis, found);
  if (found.empty()) return {};
  Message places = found.front();
  for (std::size_t n = 1; n < found.size(); ++n) places = say("{1}, {2}", places, found[n]);
  account::Verdict v;
  v.step = step;
  v.symbol = "assembly";
  v.meaning = say("every group keeps its assembly");
  v.bound = say("no change point");
  v.value = say("passed {1} times", std::to_string(found.size()));
  v.state = account::State::not_covered;
  v.note = say("the drive alone does not tell which way the mechanism goes on: {1}", places);
  return {v};
}

}  // namespace loadpath::planar
