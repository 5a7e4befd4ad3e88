#include "lib/project/references/drives/own_names.hpp"

#include "lib/calculator/meaning.hpp"
#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/drives/products.hpp"
#include "lib/project/references/drives/shares.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr std::string_view of_values = "values.";
const Dimension pressure = Dimension::of(-1, 1, -2);

/// The input is a required life, in hours or in cycles.
bool is_life(std::string_view key) { return key == "L_h" || key == "L_req" || key == "N" || key == "n_req"; }

/// Whether the value is meant for the input: it has its name, or both are lives.
bool is_meant_for(const std::string& name, const std::string& key) {
  if (name == key || name.starts_with(key + "_")) return true;
  return is_life(key) && (is_of_life(name) || has_word(name, {"n", "cycles", "repetitions"}));
}

/// Whether the input is safer by a larger value (1) or a smaller one (-1), and 0 if that is not known.
int safer_by(const Step& step, const std::string& key) {
  const FieldInfo* const field = find_field(step.input().calculator->input->fields, key);
  if (field == nullptr) return 0;
  const bool is_allowance = key == "c" && id_of(step).starts_with("vessel.");
  const bool is_required = key.starts_with("S_") || key == "S" || key == "n_st" || is_allowance;
  if (is_life(key) || ((field->is_factor || is_required) && (is_allowance || field->dimension.is_number()))) return 1;
  if (field->is_load && field->dimension == pressure) return 1;  // forces may be shared by several parts
  const bool is_strong = key == "R_e" || key == "R_m" || means(*step.input().calculator, key, &is_strength);
  return is_strong ? -1 : 0;
}

/// "values.F" of "-0.5*values.F/2" as written; empty if it is not a multiple of one value.
std::string written_multiple(std::string text) {
  std::erase(text, ' ');
  std::string found;
  for (std::size_t at = text.starts_with('-') ? 1 : 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("*/", at), text.size());
    const std::string factor = text.substr(at, end - at);
    const bool is_value = factor.starts_with(of_values) && factor.find_first_of("()+-^") == std::string::npos;
    const bool is_number = !factor.empty() && factor.find_first_not_of("0123456789.") == std::string::npos;
    if (is_value == is_number || (is_value && (!found.empty() || (at > 0 && text[at - 1] == '/')))) return {};
    if (is_value) found = factor;
    at = end + 1;
  }
  return found;
}

/// The only value that an expression refers to, where it is one of [values]; empty else.
std::string only_reference(const Operand& operand) {
  const auto& references = operand.expression.references();
  const bool is_one = !references.empty() && std::ranges::all_of(references, [&](const auto& reference) {
    return reference.path == references.front().path;
  });
  return is_one && references.front().path.starts_with(of_values) ? references.front().path : std::string();
}

/// The same, or the value that it is a multiple of as written, which may be computed from others.
std::string only_value(const Operand& operand) {
  std::string written = written_multiple(operand.text);
  return written.empty() ? only_reference(operand) : written;
}

/// The magnitude of a value of [values] with one number of this dimension; NaN if it has another.
double stated_number(const Project& project, const std::string& path, const Dimension& dimension) {
  const Value* const value = value_of_file(project, path);
  const bool is_such = value != nullptr && !value->is_series() && value->signature.dimension == dimension;
  return is_such ? std::abs(value->si.front()) : std::nan("");
}

/// Whether the input is a value of [values] as it is, which states a share by its name.
bool is_named(const Step& step, const Operand& operand) {
  const auto& typed = step.input().reading.typed;
  const auto at = typed.find(operand.path);
  return at != typed.end() && !at->second.shared.empty();
}

/// Whether the input has the product itself.
bool is_written_as_product(const Step& step, const Operand& operand) {
  return !is_named(step, operand) && operand.text.find_first_of("*/") != std::string::npos;
}

const Dimension turning = Dimension::of(0, 0, -1, 0, 1);

/// A speed that is a part of another one by a bare number: "n = =belts.n_2/60".
void compare_speed(const Step& step, const Project& project, const Operand& operand, std::vector<ReducedLoad>& found) {
  const auto& references = operand.expression.references();
  const double share = std::abs(operand.expression.plain_number());
  // at a given power, a higher speed means a lower torque
  const bool is_faster = share > 1.0 / least_share && !std::isnan(own_value(step, project, "P"));
  const bool is_slower = share > 0.0 && share < least_share;
  if (references.size() != 1 || operand.leaf.field->dimension != turning || !(is_slower || is_faster)) return;
  const std::string& path = references.front().path;
  const Value* const value = project.value(path);
  if (value == nullptr || value->signature.dimension != turning || !is_written_as_product(step, operand)) return;
  found.push_back({operand.path, say("{1} is {2} times '{3}': speeds have units, and a ratio is a value of [values] or "
                                     "of the drive; refer to it, or justify it: {4} = \"...\"",
                                     operand.path, format_number(share, 4), path, because_key(operand.path))});
}

/// "d", "D_i", and for radii "r", "R_a".
bool names_size(std::string_view name, std::string_view letters) {
  return letters.find(name[0]) != std::string_view::npos && (name.size() == 1 || name[1] == '_');
}

/// A radius that is a quarter of a diameter, or a crank of a quarter of the stroke: "R = =values.D/4".
bool is_quarter(std::string_view key, std::string_view name, double share) {
  const bool is_crank = key == "r" && (name == "s" || has_word(name, {"stroke"}));
  return ((names_size(key, "R") && names_size(name, "dD")) || is_crank) && is_near(0.25, share, few_digits);
}

/// "D" and "D_rotor", "D_a" and "D_outer": half of one is a radius. "d_1 = =values.d_2/2" is a ratio.
bool is_same_symbol(std::string_view key, std::string_view name) {
  const bool is_outer = key.size() == 1 || key == "D_a" || key == "d_a";
  const bool is_bore = key == "d_i" && has_word(name, {"bore", "inner"});
  return (is_outer || is_bore) && name.size() > 2 && name[0] == key[0] && name[1] == '_';
}

/// A diameter or a radius that is a part of the value under its own name: "D = =values.D/2" is a radius.
void compare_size(const Step& step, const Project& project, const Operand& operand, std::vector<ReducedLoad>& found) {
  constexpr double least = 0.95, most = 1.05;  // of a groove, with an allowance
  const std::string& key = operand.path;
  const Dimension& dimension = operand.leaf.field->dimension;
  const std::string path = only_value(operand);
  if (path.empty() || !names_size(key, "dDrRa") || dimension != Dimension::of(1, 0, 0) || is_named(step, operand))
    return;
  const std::string name = path.substr(of_values.size());
  const double share = std::abs(own_value(step, project, key)) / stated_number(project, path, dimension);
  const auto& fields = step.input().calculator->input->fields;
  const bool is_half =
      is_same_symbol(key, name) && is_near(0.5, share, few_digits) && find_field(fields, name) == nullptr;
  const bool is_part = is_half || (name == key && (share < least || share > most));
  if (!is_part && !is_quarter(key, name, share)) return;
  found.push_back(
      {key, say("{1} is {2} times 'values.{3}', which is a size of another meaning by its name: correct one "
                "of them, rename the value, or justify it: {4} = \"...\"",
                key, format_number(share, 4), name, because_key(key))});
}

/// The largest share of a load over the cycle, by its own list "over"; 1 if it has none.
double most_share(const Step& step, const Project& project, const std::string& path) {
  if (!path.starts_with("loads")) return 1.0;
  const std::string over = path.substr(0, path.rfind('.') + 1) + "over";
  double most = std::nan("");
  for_each_leaf(step.input().reading.record, [&](const std::string& at, const Leaf&) {
    if (at.starts_with(over) && at.ends_with(".share")) most = std::fmax(most, std::abs(own_value(step, project, at)));
  });
  return std::isnan(most) ? 1.0 : std::fmin(1.0, most);
}

/// Amplitude and mean that are parts of one value and do not add up to it: "=values.T/4" of both.
void compare_cycle(const Step& step, const Project& project, const Operand& operand, std::vector<ReducedLoad>& found) {
  const std::string path = is_part_of_cycle(step, operand) ? only_value(operand) : std::string();
  if (path.empty()) return;
  const double stated = stated_number(project, path, operand.leaf.field->dimension);
  double total = 0.0;
  std::vector<const Operand*> parts;
  for (const Operand& other : step.input().reading.operands) {
    if (!is_part_of_cycle(step, other) || only_value(other) != path) continue;
    total += std::abs(own_value(step, project, other.path));
    parts.push_back(&other);
  }
  if (parts.size() < 2 || parts.front() != &operand || !(total < least_share * stated)) return;
  found.push_back(
      {operand.path, say("amplitude and mean make up {1} times '{2}': take all of it, refer to a value that "
                         "states the share, or justify it: {3} = \"...\"",
                         format_number(total / stated, 4), path, because_key(operand.path))});
}

/// A load that is a part of a load of [values] by a bare number: "F = =values.F/4". The parts may make up the whole,
/// as two bearings with a half each; an angle states the direction of a component.
void compare_load(const Step& step, const Project& project, const Operand& operand, std::vector<ReducedLoad>& found) {
  const std::string path = only_value(operand);
  const FieldInfo& field = *operand.leaf.field;
  const double most = most_share(step, project, operand.path);
  const bool is_whole = operand.expression.is_reference() && most >= 1.0;
  if (path.empty() || !loads_a_part(field, operand.path) || is_whole) return;
  if (is_named(step, operand) && path != only_reference(operand)) return;
  if (operand.text.find("sin") != std::string::npos || operand.text.find("cos") != std::string::npos ||
      operand.text.find("tan") != std::string::npos || is_part_of_cycle(step, operand))
    return;
  const double stated = stated_number(project, path, field.dimension);
  const double share = most * std::abs(own_value(step, project, operand.path)) / stated;
  if (!(share > 0.0 && share < least_share) || is_half_of_two(step, operand, share) ||
      is_count_of_parts(step, project, operand, share))
    return;
  if (taken_in_parts(project, path, stated, field.dimension, &only_value) >= least_share * stated) return;
  found.push_back({operand.path, say("{1} is {2} times '{3}', and no input takes the rest: refer to a value that "
                                     "states the share or the number of parts, or justify it: {4} = \"...\"",
                                     operand.path, format_number(share, 4), path, because_key(operand.path))});
}

/// What the columns of the project take of a length in parts: two storeys of one height.
double taken_in_lengths(const Project& project, const std::string& path) {
  double total = 0.0;
  for (const auto& step : project.steps) {
    for (const Operand& operand : step->input().reading.operands) {
      if (operand.path == "l" && only_value(operand) == path) total += std::abs(own_value(*step, project, "l"));
    }
  }
  return total;
}

/// A length of a bar, a shell, an overhang or a link that is a part of a length of [values] by a bare number; bracing
/// or stiffening that would explain it is not stated.
void compare_length(const Step& step, const Project& project, const Operand& operand, std::vector<ReducedLoad>& found) {
  const auto& fields = step.input().calculator->input->fields;
  const bool is_of_shell = operand.path == "L" && find_field(fields, "p_e") != nullptr;
  const bool is_overhang = operand.path == "a" && id_of(step) == "shaft.overhung";
  const bool is_link = operand.path == "l" && id_of(step) == "mechanism.planar";
  const bool is_length =
      is_of_shell || is_overhang || is_link || (operand.path == "l" && find_field(fields, "n_st") != nullptr);
  const std::string path = is_length ? only_value(operand) : std::string();
  if (path.empty() || operand.expression.is_reference() || is_named(step, operand)) return;
  const double stated = stated_number(project, path, operand.leaf.field->dimension);
  const std::string& key = operand.path;
  const double share = std::abs(own_value(step, project, key)) / stated;
  if (!(share < least_share) || taken_in_lengths(project, path) >= least_share * stated) return;
  found.push_back({key, say("{3} is {1} times '{2}', and no value states why only a part counts: refer to a value that "
                            "states the number of parts, or justify it: because.{3} = \"...\"",
                            format_number(share, 4), path, key)});
}

/// A speed above the value of its own name, which no other step has: "n_1 = =values.n_1*values.i". At a given power the
/// torque is less; a lower speed is that of a later stage.
void compare_named_speed(const Step& step, const Project& project, const Operand& operand,
                         std::vector<ReducedLoad>& found) {
  const std::string path = std::string(of_values) + operand.path;
  const auto& references = operand.expression.references();
  const bool is_computed = references.size() > 1 && std::ranges::any_of(references, [&](const auto& reference) {
                             return reference.path == path;
                           });
  if (!is_computed || operand.leaf.field->dimension != turning) return;
  const double stated = magnitude_at(project, path), own = std::abs(own_value(step, project, operand.path));
  const double ratio = own / stated;
  if (!(ratio > 1.0 / least_share) || std::isnan(own_value(step, project, "P"))) return;
  const auto has_it = [&](const auto& other) {
    return std::abs(std::abs(own_value(*other, project, operand.path)) - stated) <= few_digits * stated;
  };
  if (std::ranges::any_of(project.steps, has_it)) return;
  found.push_back({operand.path, say("{1} is {2} times '{3}', and no step has that speed: correct one of them, rename "
                                     "the value, or justify it: {4} = \"...\"",
                                     operand.path, format_number(ratio, 4), path, because_key(operand.path))});
}

}  // namespace

std::vector<ReducedLoad> values_in_part(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  for (const Operand& operand : step.input().reading.operands) {
    const auto& references = operand.expression.references();
    const std::string& key = operand.path;
    const int safer = safer_by(step, key);
    const bool is_meant =
        !references.empty() &&
        is_meant_for(references.front().path.substr(std::min(of_values.size(), references.front().path.size())), key);
    if (safer != 0 && !is_meant) compare_load(step, project, operand, found);  // a pressure under another name
    if (safer == 0) {
      compare_load(step, project, operand, found);
      compare_cycle(step, project, operand, found);
      compare_speed(step, project, operand, found);
      compare_size(step, project, operand, found);
      compare_length(step, project, operand, found);
      compare_named_speed(step, project, operand, found);
    }
    if (safer == 0 || operand.expression.is_reference() || references.size() != 1) continue;
    const std::string& path = references.front().path;
    if (!path.starts_with(of_values) || !is_meant_for(path.substr(of_values.size()), key)) continue;
    const Value* const value = project.value(path);
    if (value == nullptr || !(value->signature.dimension == operand.leaf.field->dimension)) continue;
    const double stated = std::abs(magnitude_at(project, path)), taken = std::abs(own_value(step, project, key));
    const bool is_less_safe = safer > 0 ? taken < (1.0 - few_digits) * stated : taken > (1.0 + few_digits) * stated;
    if (!is_less_safe) continue;
    found.push_back({key, say("{1} is {2} times '{3}': write {1} = \"={3}\", refer to a value that explains it, or "
                              "justify it: {4} = \"...\"",
                              key, format_number(taken / stated, 4), path, because_key(key))});
  }
  return found;
}

}  // namespace loadpath::project
