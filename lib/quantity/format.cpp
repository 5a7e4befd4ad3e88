#include "lib/quantity/format.hpp"

#include "lib/quantity/number/cursor.hpp"
#include "lib/quantity/unit.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace loadpath {
namespace {

constexpr std::string_view not_available = "not available", degree = "°";

bool is_ratio(std::string_view unit) { return unit.empty() || unit == "-" || unit == "1"; }

/// The significant digits of a positive number, without the zeros behind them, and the power of ten of the first.
struct Significant {
  std::string digits;
  int ten = 0;
};

Significant significant(double value, int count) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific,
                                 std::clamp(count, 1, 17) - 1)
                       .ptr;
  const char* const e = std::find(buffer.data(), end, 'e');
  Significant number;
  std::from_chars(e + (e[1] == '+' ? 2 : 1), end, number.ten);
  std::copy_if(static_cast<const char*>(buffer.data()), e, std::back_inserter(number.digits), is_digit);
  number.digits.erase(number.digits.find_last_not_of('0') + 1);
  return number;
}

std::string with_point(std::string digits, std::size_t whole) {
  if (digits.size() <= whole) return digits.append(whole - digits.size(), '0');
  return digits.insert(whole, 1, '.');
}

}  // namespace

std::string format_number(double value, int digits) {
  if (std::isinf(value)) return "infinite";
  if (std::isnan(value)) return std::string(not_available);
  if (value == 0.0) return "0";
  const std::string sign = value < 0.0 ? "-" : "";
  const auto [written, ten] = significant(std::fabs(value), digits);
  if (ten < -4 || ten >= 7) return sign + with_point(written, 1) + "e" + std::to_string(ten);
  if (ten < 0) return sign + "0." + std::string(static_cast<std::size_t>(-ten - 1), '0') + written;
  return sign + with_point(written, static_cast<std::size_t>(ten) + 1);
}

std::string format_exact(double value) {
  std::string text;
  append_exact(value, text);
  return text;
}

void append_exact(double value, std::string& text) {
  std::array<char, 40> buffer{};
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

std::string format_quantity(double si, std::string_view unit, int digits) {
  std::string number = format_number(in_unit(si, unit), digits);
  return std::isfinite(si) ? with_unit(std::move(number), pretty_unit(unit)) : number;
}

namespace {

bool is_letter(std::string_view text, std::size_t at) {
  return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
}

/// Whether a unit of a product begins here.
bool is_unit(std::string_view name, std::string_view unit, std::size_t at) {
  return unit.substr(at).starts_with(name) && !is_letter(unit, at + name.size()) &&
         (at == 0 || !is_letter(unit, at - 1));
}

/// A unit that is written with another sign than in files.
struct UnitSign {
  std::string_view name, sign;
};
constexpr std::array unit_signs{UnitSign{"um", "µm"}, UnitSign{"deg", degree}};

}  // namespace

std::string pretty_unit(std::string_view unit) {
  if (is_ratio(unit)) return {};
  std::string pretty;
  for (Cursor in{unit}; !in.done();) {
    Cursor ahead = in;
    if (const std::string power = ahead.take("^") ? ahead.signed_integer() : ""; !power.empty()) {
      for (const char c : power) pretty += c == '-' ? "⁻" : superscripts[static_cast<std::size_t>(c - '0')];
      in = ahead;
      continue;
    }
    const auto* const sign =
        std::ranges::find_if(unit_signs, [&](const UnitSign& s) { return is_unit(s.name, unit, in.at); });
    const char c = unit[in.at];
    pretty += sign != unit_signs.end() ? sign->sign : c == '*' ? "·" : std::string_view(&unit[in.at], 1);
    in.at += sign != unit_signs.end() ? sign->name.size() : 1;
  }
  return pretty;
}

bool takes_space(std::string_view pretty) {
  return !pretty.empty() && (!pretty.starts_with(degree) || is_letter(pretty, degree.size()));
}

std::string with_unit(std::string number, std::string_view pretty, std::string_view space) {
  if (takes_space(pretty)) number += space;
  return number += pretty;
}

namespace {

/// A unit of the table, read once: a report has some thousand quantities in a few dozen units.
const ParsedUnit& known_unit(std::string_view unit) {
  static thread_local std::map<std::string, ParsedUnit, std::less<>> known;
  const auto found = known.find(unit);
  if (found != known.end()) return found->second;
  const Outcome<ParsedUnit> read = read_unit(unit, 0);
  assert(read && "the unit of a field must be in the table");
  return known.emplace(unit, *read).first->second;
}

}  // namespace

double in_unit(double si, std::string_view unit) { return is_ratio(unit) ? si : known_unit(unit).from_si(si); }

std::vector<double> in_unit(std::vector<double> si, std::string_view unit) {
  if (is_ratio(unit)) return si;
  const ParsedUnit& read = known_unit(unit);
  for (double& value : si) value = read.from_si(value);
  return si;
}

}  // namespace loadpath
