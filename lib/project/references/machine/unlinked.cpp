#include "lib/project/references/machine/unlinked.hpp"

#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

/// Equal but for the digits that are typed.
bool is_alike(double one, double other, double share = 1e-3) { return std::abs(one - other) <= share * other; }

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

/// Whether a value of the step comes from one that hands over such a record.
bool takes_from(const Step& step, const Project& project, std::string_view key) {
  return std::ranges::any_of(steps_named_in(step.input().reading), [&](const std::string& name) {
    const Step* const source = project.find(name);
    return source != nullptr && hands_over(*source, key);
  });
}

/// An end whose pressure is typed, in a file with a shell that it does not refer to.
void compare_shell(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& fields = step.input().calculator->input->fields;
  if (find_field(fields, "shell") == nullptr || !step.input().reading.typed.contains("p")) return;
  const Step* const shell = step_with(project, "shell");
  if (shell == nullptr || takes_from(step, project, "shell")) return;
  found.push_back({"p", say("the end does not refer to '{1}', whose pressure, diameter and allowance it has: give "
                            "shell = \"={1}.shell\", or because.p = \"...\" if it is of another vessel",
                            shell->name())});
}

/// The share of its thickness that the shell needs, below which an end may not count on its strength.
void compare_share(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& records = step.input().reading.records;
  const auto shell = std::ranges::find(records, "shell", &Taken::path);
  if (shell == records.end() || !step.input().reading.typed.contains("m_r")) return;
  const std::string name = split_step(shell->source).first;
  const double c = magnitude_at(project, shell->source + ".c"), allowed = std::isnan(c) ? 0.0 : c;
  const double share =
      (magnitude_at(project, name + ".delta_min") - allowed) / (magnitude_at(project, name + ".delta") - allowed);
  const double m_r = own_value(step, project, "m_r");
  if (!(m_r < share) || is_alike(m_r, share)) return;
  found.push_back({"m_r", say("m_r = {1}, and '{2}' needs {3} of its thickness; justify it: because.m_r = \"...\"",
                              format_number(m_r, 4), name, format_number(share, 4))});
}

double typed_value(const Step& step, const Project& project, const char* path) {
  return std::abs(own_value(step, project, path));
}

/// The two bearings of a pair carry the axial force in opposite directions. Several pairs may have the same loads.
void compare_mate(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const Leaf carries = find_leaf(step.input().reading.record, "carries");
  const double F_r = typed_value(step, project, "F_r"), of_mate = typed_value(step, project, "mate.F_r");
  if (!carries || std::isnan(of_mate)) return;
  std::vector<const Step*> mates;
  for (const auto& other : project.steps) {
    if (other.get() == &step || other->input().calculator != step.input().calculator) continue;
    if (is_alike(typed_value(*other, project, "F_r"), of_mate) &&
        is_alike(typed_value(*other, project, "mate.F_r"), F_r))
      mates.push_back(other.get());
  }
  const auto carries_same = [&](const Step* mate) {
    return find_leaf(mate->input().reading.record, "carries").get() == carries.get();
  };
  if (mates.empty() || !std::ranges::all_of(mates, carries_same)) return;
  found.push_back(
      {"carries", say("'{1}' carries the axial force in the same direction; the two bearings of a pair carry "
                      "opposite ones: justify it: because.carries = \"...\"",
                      mates.front()->name())});
}

bool is_fatigue_limit(std::string_view what) { return what == limit_in_normal || what == limit_in_shear; }

/// Whether both are of one material: of the same row, or of the same tensile strength.
bool is_of_same_material(const Step& one, const Step& other, const Project& project) {
  const std::string row = material_of(one);
  if (!row.empty() && row == material_of(other)) return true;
  return is_alike(own_value(other, project, "R_m"), own_value(one, project, "R_m"), 0.01);
}

/// Whether a step finds such a fatigue limit and takes none: in torsion that of shear stresses.
bool finds_limit(const Step& step, std::string_view key) {
  const Calculator* const calculator = step.input().calculator;
  if (calculator == nullptr || calculator->result == nullptr || step.input().reading.record.data == nullptr)
    return false;
  if (find_field(calculator->result->fields, "sigma_D") == nullptr ||
      find_field(calculator->input->fields, "sigma_D") != nullptr)
    return false;
  const Leaf loading = find_leaf(step.input().reading.record, "loading");
  return loading && (word_of(loading) == "torsion") == (key == "tau_D");
}

/// A fatigue limit that is typed, in a file with a step that finds it and whose result nothing takes.
void compare_limit(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto& reading = step.input().reading;
  for (const char* const key : {"sigma_D", "tau_D"}) {
    const auto is_taken = [&](const Operand& o) { return o.path == key && !o.expression.references().empty(); };
    if (!reading.typed.contains(key) || std::ranges::any_of(reading.operands, is_taken) ||
        !means(*step.input().calculator, key, &is_fatigue_limit))
      continue;
    for (const auto& other : project.steps) {
      const std::string path = other->name() + ".sigma_D";
      const bool is_used = std::ranges::find(project.references, path) != project.references.end();
      if (other.get() == &step || is_used || !finds_limit(*other, key) || !is_of_same_material(step, *other, project))
        continue;
      found.push_back({key, say("{1} is typed, and no step uses '{2}': write {1} = \"={2}\", or because.{1} = \"...\"",
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
