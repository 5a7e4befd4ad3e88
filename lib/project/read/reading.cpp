#include "lib/project/read/reading.hpp"

#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

using Type = FieldInfo::Type;

static std::size_t code_points(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::optional<std::string> lone_reference(const toml::Tree& tree) {
  if (tree.type != toml::Tree::Type::text || !tree.text.starts_with('=')) return std::nullopt;
  const auto parsed = Expression::parse(std::string_view(tree.text).substr(1));
  if (!parsed || !parsed->is_reference()) return std::nullopt;
  return parsed->references().front().path;
}

std::optional<toml::Tree> number_of(const toml::Tree& tree,
                                    const std::function<const Value*(const std::string&)>& known) {
  if (tree.type != toml::Tree::Type::text || !tree.text.starts_with('=')) return std::nullopt;
  toml::Tree number = tree;
  number.text = tree.text.substr(1);
  const auto parsed = Expression::parse(number.text);
  if (!parsed) return std::nullopt;
  for (const auto& reference : parsed->references()) {
    if (known(reference.path) == nullptr) return std::nullopt;
  }
  const auto value = parsed->evaluate([&](const std::string& path) -> const Value& { return *known(path); });
  // A moment over radians is a moment to a field that takes the expression; a literal states its kind.
  const Dimension& dimension = value.signature.dimension;
  const bool has_angle = dimension != dimension.without_angle();
  if (has_angle && !dimension.is_angle_or_number() && dimension != Dimension::of(0, 0, -1, 0, 1)) return std::nullopt;
  const bool typed = static_cast<bool>(parse_literal(number.text));
  if (typed && (!dimension.is_number() || number.text.ends_with("%"))) return number;
  if (!std::isfinite(value.si[0])) return std::nullopt;
  const std::string unit = si_unit(value.signature.dimension);
  if (unit.empty()) number.type = toml::Tree::Type::number, number.number = value.si[0];
  number.text = format_exact(value.si[0]) + (unit.empty() ? "" : " " + unit);
  return number;
}

bool is_of_record(const Reading& reading, const std::string& path) {
  const auto fills = [&](const auto& taken) { return taken.of_record && taken.path == path; };
  return std::any_of(reading.operands.begin(), reading.operands.end(), fills) ||
         std::any_of(reading.taken.begin(), reading.taken.end(), fills);
}

Issue missing_field(const MissingInput& missing, const std::string& prefix) {
  const FieldInfo& field = *missing.field;
  const bool in_unit = field.type == Type::quantity && std::string_view(field.unit) != "-";
  const bool is_sought = *field.searched_in != '\0';
  return {missing.place,
          prefix + missing.path,
          say("'{1}' is missing: {2}", missing.path, field.doc),
          in_unit && is_sought ? say("write {1} = \"... {2}\", or {1} = \"?\" to find it", field.key, field.unit)
          : in_unit            ? say("write {1} = \"... {2}\"", field.key, field.unit)
                               : Message{},
          Severity::error,
          KeyFault::missing};
}

Message bounds_message(const FieldInfo& field) {
  const Range& b = field.bounds;
  const std::string unit = field.type == Type::quantity ? field.unit : "-";
  const std::string low = (b.low_open ? "> " : ">= ") + format_quantity(b.low, unit);
  const std::string high = (b.high_open ? "< " : "<= ") + format_quantity(b.high, unit);
  if (std::isinf(b.high)) return say("must be {1}", low);
  if (std::isinf(b.low)) return say("must be {1}", high);
  return say("must be {1} and {2}", low, high);
}

double without_margin(const FieldInfo& field, double bound) {
  constexpr double margin = 1e-5;
  const double shown = in_unit(bound, field.unit), whole = std::round(shown);
  if (!std::isfinite(shown) || std::abs(shown - whole) > margin) return bound;
  return whole == 0.0 ? 0.0 : bound * (whole / shown);
}

bool is_open_above(const FieldInfo& field) {
  constexpr double boundless = 1e6;
  return in_unit(field.bounds.high, field.unit) >= boundless;
}

Message bound_message(const FieldInfo& field, double si) {
  const bool is_above = si > field.bounds.high;
  const double bound = without_margin(field, is_above ? field.bounds.high : field.bounds.low);
  const std::string shown = format_quantity(bound, field.unit);
  return is_above ? say("must be at most {1}", shown) : say("must be at least {1}", shown);
}

Message unusual(const std::string& path, const FieldInfo& field, double si) {
  return say("{1} = {2} is unusual: {3} to {4} is expected", path, format_quantity(si, field.unit),
             format_quantity(field.plausible.low, field.unit), format_quantity(field.plausible.high, field.unit));
}

Message unusual_hint(const FieldInfo& field) {
  return field.dimension.is_number() ? say("check the value") : say("check the unit");
}

bool is_name(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  return !text.empty() && letter(text[0]) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || digit(c); });
}

Place place_in(const Place& start, std::string_view text, std::size_t at, std::size_t length) {
  Place place = start;
  at = std::min(at, text.size());
  place.column += static_cast<int>(code_points(text.substr(0, at)));
  place.length = static_cast<int>(std::max<std::size_t>(1, code_points(text.substr(at, length))));
  return place;
}

}  // namespace loadpath::project
