#include "lib/project/references/drives/own_names.hpp"

#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double few_digits = 0.02;  // values that are written with few digits
constexpr std::string_view of_values = "values.";
const Dimension pressure = Dimension::of(-1, 1, -2);

bool is_strength(std::string_view what) {
  return strength_bound_of(what) != nullptr || what == allowable_in_normal || what == allowable_in_shear;
}

/// The input is a required life, in hours or in cycles.
bool is_life(std::string_view key) { return key == "L_h" || key == "L_req" || key == "N" || key == "n_req"; }

/// Whether the value is meant for the input: it has its name, or both are lives.
bool is_meant_for(const std::string& name, const std::string& key) {
  if (name == key) return true;
  return is_life(key) && (is_of_life(name) || has_word(name, {"n", "cycles", "repetitions"}));
}

/// Whether the input is safer by a larger value (1) or a smaller one (-1), and 0 if that is not known.
int safer_by(const Step& step, const std::string& key) {
  const FieldInfo* const field = find_field(step.input().calculator->input->fields, key);
  if (field == nullptr) return 0;
  const bool is_required = key.starts_with("S_") || key == "S" || key == "n_st";
  if (is_life(key) || ((field->is_factor || is_required) && field->dimension.is_number())) return 1;
  if (field->is_load && field->dimension == pressure) return 1;  // forces may be shared by several parts
  const bool is_strong = key == "R_e" || key == "R_m" || means(*step.input().calculator, key, &is_strength);
  return is_strong ? -1 : 0;
}

}  // namespace

std::vector<ReducedLoad> values_in_part(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  for (const Operand& operand : step.input().reading.operands) {
    const auto& references = operand.expression.references();
    const std::string& key = operand.path;
    const int safer = safer_by(step, key);
    if (safer == 0 || operand.expression.is_reference() || references.size() != 1) continue;
    const std::string& path = references.front().path;
    if (!path.starts_with(of_values) || !is_meant_for(path.substr(of_values.size()), key)) continue;
    const Value* const value = project.value(path);
    if (value == nullptr || !(value->signature.dimension == operand.leaf.field->dimension)) continue;
    const double stated = std::abs(magnitude_at(project, path)), taken = std::abs(own_value(step, project, key));
    if (!(stated > 0.0)) continue;
    const bool is_less_safe = safer > 0 ? taken < (1.0 - few_digits) * stated : taken > (1.0 + few_digits) * stated;
    if (!is_less_safe) continue;
    found.push_back({key, say("{1} is {2} times '{3}': write {1} = \"={3}\", refer to a value that explains it, or "
                              "justify it: {4} = \"...\"",
                              key, format_number(taken / stated, 4), path, because_key(key))});
  }
  return found;
}

}  // namespace loadpath::project
