#include "lib/table/names.hpp"

#include "lib/text/issue.hpp"
#include "lib/text/utf8.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace loadpath::table {

namespace {

bool is_digit(char32_t c) { return U'0' <= c && c <= U'9'; }

/// "HEA 155": the letters "hea", the number 155 and the rest.
struct Numbered {
  std::u32string letters, digits, rest;
  double number = std::numeric_limits<double>::quiet_NaN();
};

Numbered numbered(std::string_view name) {
  const std::u32string text = folded(name);
  const auto first = std::find_if(text.begin(), text.end(), is_digit);
  const auto last = std::find_if_not(first, text.end(), is_digit);
  if (first == last || last - first > 9) return {text, {}, {}};
  Numbered parts{{text.begin(), first}, {first, last}, {last, text.end()}, 0.0};
  for (const char32_t digit : parts.digits) parts.number = 10.0 * parts.number + static_cast<double>(digit - U'0');
  std::sort(parts.digits.begin(), parts.digits.end());
  return parts;
}

bool is_of_series(const Numbered& wanted, const Numbered& other) {
  return other.letters == wanted.letters && !std::isnan(other.number) &&
         (other.rest == wanted.rest || wanted.rest.empty());
}

/// The distance of a name from the requested one: the same digits in another order are a typing error.
std::tuple<bool, double, bool> far(const Numbered& wanted, const Numbered& other) {
  return {other.digits != wanted.digits, std::fabs(wanted.number - other.number), other.rest != wanted.rest};
}

/// Among the names with the same letters in front and behind, the one with the nearest number; a material by its
/// number only ("1.0038") has no letters, and is treated as a misspelling.
std::string near_number(std::string_view name, const std::vector<std::string>& names) {
  const Numbered wanted = numbered(name);
  if (std::isnan(wanted.number) || wanted.letters.empty()) return {};
  std::tuple least{true, std::numeric_limits<double>::infinity(), true};
  std::string found;
  for (const std::string& candidate : names) {
    const Numbered other = numbered(candidate);
    if (!is_of_series(wanted, other)) continue;
    if (far(wanted, other) < least) least = far(wanted, other), found = candidate;
  }
  return found;
}

}  // namespace

std::u32string folded(std::string_view name) {
  std::u32string points = code_points(name);
  std::erase_if(points, [](char32_t c) { return c == U' ' || c == U'-'; });
  std::transform(points.begin(), points.end(), points.begin(), lower_case);
  return points;
}

std::string near_name(std::string_view name, const std::vector<std::string>& names) {
  std::string near = near_number(name, names);
  return near.empty() ? nearest(name, names) : near;
}

}  // namespace loadpath::table
