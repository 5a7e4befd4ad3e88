#include "lib/project/references/drives/shares.hpp"

#include "lib/calculator/meaning.hpp"
#include "lib/project/references/drives/products.hpp"
#include "lib/project/references/origins.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace loadpath::project {

namespace {

bool is_reduced_by_definition(std::string_view what) {
  return what == "amplitude" || what == "mean" || what == "min" || what == paired_amplitude || what == paired_middle;
}

}  // namespace

bool loads_a_part(const FieldInfo& field, std::string_view path) {
  const bool is_moved = path.starts_with("links.") || path.starts_with("parts");
  const bool is_mass =
      (field.dimension == Dimension::of(0, 1, 0) || field.dimension == Dimension::of(2, 1, 0)) && is_moved;
  return (field.is_load && !field.dimension.is_number()) || is_mass;
}

bool is_part_of_cycle(const Step& step, const Operand& operand) {
  const bool is_power = operand.leaf.field->dimension == Dimension::of(2, 1, -3);
  return !is_power && means(*step.input().calculator, operand.path, &is_reduced_by_definition);
}

bool is_count_of_parts(const Step& step, const Project& project, const Operand& operand, double share) {
  if (operand.path.starts_with("seats")) return false;  // counts of the shaft are none of a mounted component
  const auto& fields = step.input().calculator->input->fields;
  return std::ranges::any_of(fields, [&](const FieldInfo& field) {
    const std::string_view key = field.key;
    const bool is_ratio = field.is_number() && field.dimension.is_number() && (key == "i" || key == "u");
    if (field.type != FieldInfo::Type::count && !is_ratio) return false;  // a safety factor explains no share
    if (key.starts_with("z_")) return false;                              // teeth share no load
    const bool is_given =
        step.input().reading.typed.contains(field.key) || step.input().reading.operand(field.key) != nullptr;
    if (!is_given) return false;  // the usual number of pulleys
    const double number = std::abs(own_value(step, project, field.key));
    return is_near(number * share, 1.0, few_digits) || is_near(number, share, few_digits);
  });
}

bool is_half_of_two(const Step& step, const Operand& operand, double share) {
  constexpr double half = 0.5;
  const bool is_whole = id_of(step).starts_with("column.") || operand.path.starts_with("loads");
  if (is_whole) return false;
  const Dimension& dimension = operand.leaf.field->dimension;
  const bool is_on_shaft = operand.path.starts_with("seats");  // the other half would be on it, too
  const bool is_shared = !is_on_shaft && (dimension == Dimension::of(1, 1, -2) || dimension == Dimension::of(0, 1, 0));
  if (!is_shared || !(share >= (1.0 - few_digits) * half)) return false;
  std::string text = operand.text;
  std::erase(text, ' ');
  for (std::size_t at = text.find("/2"); at != std::string::npos; at = text.find("/2", at + 1)) {
    const char next = at + 2 < text.size() ? text[at + 2] : ' ';
    if (next != '.' && std::isdigit(static_cast<unsigned char>(next)) == 0) return true;
  }
  return text.find("0.5*") != std::string::npos || text.ends_with("*0.5");
}

double number_of_named_value(const Operand& operand, const Project& project) {
  auto written = Expression::parse(operand.text);
  if (!written) return std::nan("");
  const bool is_of_value = std::ranges::any_of(written->references(), [&](const auto& reference) {
    const Value* const value = value_of_file(project, reference.path);
    return reference.path.find('_') != std::string::npos && value != nullptr &&
           value->signature.dimension == operand.leaf.field->dimension;
  });
  if (!is_of_value) return std::nan("");
  Operand here{operand.path, operand.leaf, std::move(*written), operand.text, operand.place};
  const auto product = product_of(here, project);
  return product ? std::abs(product->number) : std::nan("");
}

double taken_in_parts(const Project& project, const std::string& values, double whole, const Dimension& dimension,
                      const ValuesOf& values_of) {
  double total = 0.0;
  for (const auto& step : project.steps) {
    for (const Operand& operand : step->input().reading.operands) {
      const FieldInfo& field = *operand.leaf.field;
      if (!loads_a_part(field, operand.path) || field.dimension != dimension || values_of(operand) != values) continue;
      const double own = std::abs(own_value(*step, project, operand.path));
      if (own < least_share * whole) total += own;
    }
  }
  return total;
}

}  // namespace loadpath::project
