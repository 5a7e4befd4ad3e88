#include "lib/project/run/field_role.hpp"

#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace loadpath::project {

namespace {

constexpr double rounding_of_numbers = 1e-6, most_rounding = 0.01;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The number at the start of a literal, and the number of its decimal places.
struct Digits {
  std::string number;
  int decimals = 0;
};

Digits digits_of(std::string_view text) {
  Digits digits;
  bool behind = false;
  std::size_t i = 0;
  for (; i < text.size(); ++i) {
    const char c = text[i] == ',' ? '.' : text[i];
    const bool is_sign = i == 0 && (c == '-' || c == '+');
    if (!is_digit(c) && c != '.' && !is_sign) break;
    if (c == '.' && behind) break;
    if (is_digit(c) && behind) ++digits.decimals;
    behind = behind || c == '.';
    digits.number += c;
  }
  const bool has_power = i < text.size() && (text[i] == 'e' || text[i] == 'E') && i + 1 < text.size() &&
                         (is_digit(text[i + 1]) || text[i + 1] == '-' || text[i + 1] == '+');
  if (has_power) digits.number += text.substr(i, text.find_first_not_of("+-0123456789", i + 1) - i);
  return digits;
}

}  // namespace

FieldRole role_of_dimension(const Dimension& dimension) {
  const auto& powers = dimension.twelfths;
  return powers[Dimension::mass] > 0 && powers[Dimension::time] < 0 ? FieldRole::capacity : FieldRole::identity;
}

FieldRole role_of_field(const FieldInfo& field) {
  if (field.is_load || field.larger_is_better || field.is_factor) return FieldRole::demand;
  // Another modulus is another metal, stronger or not.
  const std::string_view column = field.provider.column;
  if (column == "E" || column == "G") return FieldRole::modulus;
  // A slower part than that of the row is conservative: a limiting speed with other grease.
  const bool is_limiting_speed =
      *field.provider.table != '\0' && field.dimension.without_angle() == Dimension::of(0, 0, -1);
  if (is_limiting_speed) return FieldRole::capacity;
  return field.type == FieldInfo::Type::quantity ? role_of_dimension(field.dimension) : FieldRole::identity;
}

std::string facts_of(const FieldInfo& field) {
  if (*field.shared_as != '\0') return field.shared_as;
  const Provider& from = field.provider;
  return from.kind == Provider::Kind::table && from.table == std::string_view("material") ? from.column : "";
}

FieldRole role_in_body(const FieldInfo& field) {
  if (field.type == FieldInfo::Type::choice) return FieldRole::either;
  return *field.least_of_source != '\0' ? FieldRole::demand : role_of_field(field);
}

bool is_empirical(const FieldInfo& field) {
  const auto stress = Dimension::of(-1, 1, -2), density = Dimension::of(-3, 1, 0);
  const bool is_bounded = std::isfinite(field.plausible.low) || std::isfinite(field.plausible.high);
  return is_bounded && field.type == FieldInfo::Type::quantity && !field.is_load && !field.is_factor &&
         !field.larger_is_better && *field.searched_in == '\0' &&
         (field.dimension.is_number() || field.dimension == stress || field.dimension == density);
}

double relative_rounding(std::string_view typed) {
  if (typed.starts_with('=')) typed.remove_prefix(1);
  while (typed.starts_with(' ')) typed.remove_prefix(1);
  if (!parse_literal(typed)) return rounding_of_numbers;
  const Digits digits = digits_of(typed);
  const double number = std::abs(std::strtod(digits.number.c_str(), nullptr));
  if (number == 0.0) return rounding_of_numbers;
  const std::size_t power = digits.number.find_first_of("eE");
  const double ten = power == std::string::npos ? 0.0 : std::strtod(digits.number.c_str() + power + 1, nullptr);
  const double half_unit = 0.5 * std::pow(10.0, ten - digits.decimals);
  return std::clamp(half_unit / number * (1.0 + 1e-9), rounding_of_numbers, most_rounding);
}

bool is_equal(FieldRole role, double typed, double other, double rounding) {
  constexpr double of_moduli = 0.06;  // books have 200 to 210 GPa for the same steel
  if (role == FieldRole::either) typed = std::abs(typed), other = std::abs(other);  // both directions of rotation
  if (role == FieldRole::modulus) rounding = std::max(rounding, of_moduli);
  return typed == other || std::abs(typed - other) <= rounding * std::abs(typed);
}

bool keeps(const KeptBound& bound, double value) {
  return std::isnan(value) || is_equal(bound.kind, bound.typed, value, bound.rounding) ||
         (!std::isnan(bound.typed) && !is_bolder(bound.kind, bound.typed, value));
}

bool is_bolder(FieldRole role, double typed, double other) {
  if (role == FieldRole::usual || role == FieldRole::either) return true;
  return role == FieldRole::capacity ? typed > other : std::abs(typed) < std::abs(other);
}

}  // namespace loadpath::project
