#include "lib/project/references/machine/unlinked.hpp"

#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

bool hands_over(const Step& step, std::string_view key) {
  const Calculator* const calculator = step.input().calculator;
  const FieldInfo* const field =
      calculator == nullptr || calculator->result == nullptr ? nullptr : find_field(calculator->result->fields, key);
  return field != nullptr && field->is_handed_over;
}

/// The first step that hands over such a record; null if there is none.
const Step* step_with(const Project& project, std::string_view key) {
  const auto found = std::ranges::find_if(project.steps, [&](const auto& step) { return hands_over(*step, key); });
  return found == project.steps.end() ? nullptr : found->get();
}

/// An end whose pressure is typed beside a shell.
void compare_shell(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& fields = step.input().calculator->input->fields;
  const auto& records = step.input().reading.records;
  const bool takes = std::ranges::any_of(records, [](const Taken& record) { return record.path == "shell"; });
  if (find_field(fields, "shell") == nullptr || takes || !find_leaf(step.input().reading.record, "p")) return;
  const Step* const shell = step_with(project, "shell");
  if (shell == nullptr) return;
  found.push_back({"p", say("the end does not refer to '{1}', whose pressure, diameter and allowance it has: give "
                            "shell = \"={1}.shell\", or because.p = \"...\" if it is of another vessel",
                            shell->name())});
}

/// The share of its thickness that the shell needs, below which an end may not count on its strength.
void compare_share(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double alike = 1e-3;
  const auto& records = step.input().reading.records;
  const auto shell = std::ranges::find(records, "shell", &Taken::path);
  if (shell == records.end() || !step.input().reading.typed.contains("m_r")) return;
  const std::string name = split_step(shell->source).first;
  const double c = magnitude_at(project, shell->source + ".c"), allowed = std::isnan(c) ? 0.0 : c;
  const double share =
      (magnitude_at(project, name + ".delta_min") - allowed) / (magnitude_at(project, name + ".delta") - allowed);
  if (!(own_value(step, project, "m_r") < share * (1.0 - alike))) return;
  found.push_back({"m_r", say("m_r = {1}, and '{2}' needs {3} of its thickness; justify it: because.m_r = \"...\"",
                              format_number(own_value(step, project, "m_r"), 4), name, format_number(share, 4))});
}

double typed_value(const Step& step, const Project& project, const char* path) {
  return std::abs(own_value(step, project, path));
}

/// Of two bearings that are mates one carries the force in each direction.
void compare_mate(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  constexpr double alike = 1e-3;
  const Leaf carries = find_leaf(step.input().reading.record, "carries");
  const double F_r = typed_value(step, project, "F_r"), of_mate = typed_value(step, project, "mate.F_r");
  if (!carries || std::isnan(of_mate)) return;
  for (const auto& other : project.steps) {
    if (other.get() == &step || other->input().calculator != step.input().calculator) continue;
    const Leaf theirs = find_leaf(other->input().reading.record, "carries");
    const bool is_mate = std::abs(typed_value(*other, project, "F_r") - of_mate) <= alike * of_mate &&
                         std::abs(typed_value(*other, project, "mate.F_r") - F_r) <= alike * F_r;
    if (!is_mate || carries.get() != theirs.get()) continue;
    found.push_back({"carries", say("'{1}' carries the force in the same direction, and of a pair each carries one: "
                                    "justify it: because.carries = \"...\"",
                                    other->name())});
  }
}

bool is_fatigue_limit(std::string_view what) { return what == limit_in_normal || what == limit_in_shear; }

/// A fatigue limit that is typed, beside a step whose fatigue limit nothing takes.
void compare_limit(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  for (const char* const key : {"sigma_D", "tau_D"}) {
    const auto& typed = step.input().reading.typed;
    if (!typed.contains(key) || !means(*step.input().calculator, key, &is_fatigue_limit)) continue;
    const auto& operands = step.input().reading.operands;
    const auto is_it = [&](const Operand& o) { return o.path == key && !o.expression.references().empty(); };
    if (std::ranges::any_of(operands, is_it)) continue;
    for (const auto& other : project.steps) {
      const Calculator* const calculator = other->input().calculator;
      if (other.get() == &step || calculator == nullptr || calculator->result == nullptr) continue;
      const std::string path = other->name() + ".sigma_D";
      const bool finds = find_field(calculator->result->fields, "sigma_D") != nullptr &&
                         find_field(calculator->input->fields, "sigma_D") == nullptr;
      if (!finds || std::ranges::find(project.references, path) != project.references.end()) continue;
      found.push_back({key, say("{1} is typed, and nothing takes '{2}': write {1} = \"={2}\", or because.{1} = \"...\"",
                                key, path)});
    }
  }
}

}  // namespace

std::vector<ReducedLoad> values_of_unlinked(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  if (step.input().calculator == nullptr || step.input().reading.record.data == nullptr) return found;
  compare_shell(step, project, found);
  compare_share(step, project, found);
  compare_mate(step, project, found);
  compare_limit(step, project, found);
  return found;
}

}  // namespace loadpath::project
