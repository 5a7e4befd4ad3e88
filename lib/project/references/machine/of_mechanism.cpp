#include "lib/project/references/machine/of_mechanism.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace loadpath::project {

namespace {

const Dimension force = Dimension::of(1, 1, -2);

/// The key under which a mechanism has the crank angles that it is solved at, in place of a revolution.
constexpr std::string_view given_angles = "crank.at";

bool is_at_given_angles(const Step& step) {
  const auto& typed = step.input().reading.typed;
  return std::ranges::any_of(typed, [](const auto& entry) { return entry.first.starts_with(given_angles); });
}

void hold_parts_of_turn(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  std::set<std::string> held;
  for (const Operand& operand : step.input().reading.operands) {
    if (!operand.leaf.field->is_load || held.contains(operand.path)) continue;
    for (const auto& reference : operand.expression.references()) {
      const Step* const source = project.find(split_step(reference.path).first);
      if (source == nullptr || source == &step || !is_at_given_angles(*source)) continue;
      held.insert(operand.path);
      found.push_back(
          {operand.path, say("'{1}' is solved at given crank angles, not over its cycle: leave out crank.at, "
                             "or justify it: because.{2} = \"...\"",
                             source->name(), operand.path)});
      break;
    }
  }
}

/// The least of the largest forces of the joints of a solved mechanism; NaN if it has none.
double least_joint_force(const Step& mechanism) {
  double least = std::nan("");
  for (const account::Entry& entry : mechanism.account().results) {
    if (!entry.path.starts_with("joints.") || !entry.path.ends_with(".F") || entry.value.si.empty()) continue;
    double most = 0.0;
    for (const double si : entry.value.si) most = std::fmax(most, std::abs(si));
    least = std::fmin(least, most);
  }
  return least;
}

/// A force typed beside values of a mechanism: "F = 1 kN" with "n = =press.links.rod.omega".
void compare_typed_forces(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  for (const std::string& name : steps_named_in(step.input().reading)) {
    const Step* const source = project.find(name);
    if (source == nullptr || source == &step) continue;
    const double least = least_joint_force(*source);
    if (!(least > 0.0)) continue;
    for (const auto& [path, typed] : step.input().reading.typed) {
      const Leaf leaf = find_leaf(step.input().reading.record, path);
      const bool is_force = leaf && leaf.field->is_load && leaf.field->dimension == force;
      const double own = is_force ? std::abs(leaf.get()) : std::nan("");
      const auto& operands = step.input().reading.operands;
      const bool is_taken = std::ranges::any_of(operands, [&](const Operand& o) { return o.path == path; });
      if (is_taken || path.find_first_of(".[") != std::string::npos || !(own > 0.0 && own < 0.99 * least)) continue;
      found.push_back(
          {path, say("{1} = {2}, below the force of every joint of '{3}', at least {4}: take it from there, or "
                     "justify it: because.{1} = \"...\"",
                     path, format_quantity(own, "kN", 4), name, format_quantity(least, "kN", 4))});
    }
  }
}

}  // namespace

std::vector<ReducedLoad> loads_of_mechanism(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  if (step.input().calculator == nullptr) return found;
  hold_parts_of_turn(step, project, found);
  compare_typed_forces(step, project, found);
  return found;
}

}  // namespace loadpath::project
