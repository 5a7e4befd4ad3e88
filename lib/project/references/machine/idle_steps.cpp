#include "lib/project/references/machine/idle_steps.hpp"

#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

bool is_fatigue_limit(std::string_view what) { return what == limit_in_normal || what == limit_in_shear; }

bool has_input(const Step& step, std::string_view key) {
  return find_field(step.input().calculator->input->fields, key) != nullptr;
}
bool has_result(const Step& step, std::string_view key) {
  const auto* const result = step.input().calculator->result;
  return result != nullptr && find_field(result->fields, key) != nullptr;
}

/// Whether both are of one material: of the same row, or of the same tensile strength.
bool is_of_same_material(const Step& one, const Step& other, const Project& project) {
  const std::string row = material_of(one);
  if (!row.empty() && row == material_of(other)) return true;
  return is_near(own_value(other, project, "R_m"), own_value(one, project, "R_m"), 0.01);
}

/// Whether a step finds such a fatigue limit and takes none: in torsion that of shear stresses.
bool finds_limit(const Step& step, std::string_view key) {
  if (!has_result(step, "sigma_D") || has_input(step, "sigma_D")) return false;
  const Leaf loading = find_leaf(step.input().reading.record, "loading");
  return loading && (word_of(loading) == "torsion") == (key == "tau_D");
}

/// Limits that tests give, and their values at a survival probability.
constexpr std::array limits_of_tests{"S_P", "S_50", "S_D", "sigma_P"};

/// "bars.S_P": the first limit of a step of tests, where nothing takes any of them; empty if there is none.
std::string idle_limit_of_tests(const Step& step, const Project& project) {
  std::string first;
  if (!has_input(step, "tests") && !has_input(step, "T_S")) return first;
  for (const char* const key : limits_of_tests) {
    const std::string path = step.name() + "." + key;
    if (!has_result(step, key)) continue;
    if (project.is_referred_to(path)) return {};
    if (first.empty()) first = path;
  }
  return first;
}

/// Whether an input is a result of another step, or of its expression. An input of `idle`, such as the limit of half of
/// the parts, is not one.
bool is_taken(const Step& step, std::string_view key, const Step& idle) {
  const auto takes = [&](const Operand& operand) {
    return operand.path == key && std::ranges::any_of(operand.expression.references(), [&](const auto& reference) {
             const auto [name, rest] = split_step(reference.path);
             return name != "values" && !(name == idle.name() && has_input(idle, rest));
           });
  };
  return std::ranges::any_of(step.input().reading.operands, takes);
}

/// A fatigue limit that is typed, in a file with a step that finds it and whose result nothing takes.
void compare_limit(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  for (const char* const key : {"sigma_D", "tau_D"}) {
    if (!step.input().reading.typed.contains(key) || !means(*step.input().calculator, key, &is_fatigue_limit)) continue;
    for (const auto& other : project.steps) {
      if (other.get() == &step || is_taken(step, key, *other)) continue;
      std::string path = other->name() + ".sigma_D";
      const bool is_found =
          finds_limit(*other, key) && !project.is_referred_to(path) && is_of_same_material(step, *other, project);
      if (!is_found) path = std::string_view(key) == "sigma_D" ? idle_limit_of_tests(*other, project) : "";
      if (path.empty() || !(own_value(step, project, key) > magnitude_at(project, path))) continue;
      found.push_back({key, say("{1} is typed, and no step uses '{2}': write {1} = \"={2}\", or because.{1} = \"...\"",
                                key, path)});
    }
  }
}

/// Whether the effective length that is typed is shorter than of this factor: as a factor, or as clamped ends.
bool is_shorter(const Step& step, const Project& project, const std::string& key, double beta) {
  if (key.starts_with("beta")) return own_value(step, project, key) < beta * (1.0 - 1e-3);
  constexpr double clamped = 0.5, clamped_and_pinned = 0.699;
  const Leaf ends = find_leaf(step.input().reading.record, key);
  const std::string word = ends && ends.field->type == FieldInfo::Type::choice ? std::string(word_of(ends)) : "";
  if (word == "fixed_fixed") return clamped < beta * (1.0 - 1e-3);
  return (word == "fixed_pinned" || word == "pinned_fixed") && clamped_and_pinned < beta * (1.0 - 1e-3);
}

constexpr std::array keys_of_ends{"beta_y", "beta_z", "ends", "ends_y", "ends_z"};

/// The ends of a column that are typed, in a file with a step that finds the effective length of such a column.
void compare_effective_length(const Step& step, const Project& project, std::vector<ReducedLoad>& found) {
  const auto is_typed = [&](const char* key) { return step.input().reading.typed.contains(key); };
  if (std::ranges::none_of(keys_of_ends, is_typed)) return;
  for (const auto& other : project.steps) {
    if (other.get() == &step || !has_input(*other, "end_1") || !has_result(*other, "beta")) continue;
    const std::string beta = other->name() + ".beta";
    if (project.is_referred_to(beta) || project.is_referred_to(other->name() + ".s") ||
        !is_near(own_value(*other, project, "l"), own_value(step, project, "l"), 1e-3))
      continue;
    const double found_there = magnitude_at(project, beta);
    for (const char* const key : keys_of_ends) {
      if (!is_typed(key) || !is_shorter(step, project, key, found_there)) continue;
      found.push_back(
          {key, say("{1} is typed, and no step uses '{2}' of a bar of the same length: write beta_y or beta_z "
                    "= \"={2}\", or because.{1} = \"...\"",
                    key, beta)});
      break;
    }
  }
}

}  // namespace

std::vector<ReducedLoad> values_of_idle_steps(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  compare_limit(step, project, found);
  compare_effective_length(step, project, found);
  return found;
}

}  // namespace loadpath::project
