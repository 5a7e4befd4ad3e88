#include "lib/project/layout/layout.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/quantity/number/number.hpp"
#include "lib/text/utf8.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

/// A unit in letters that every keyboard has: N*m, mm^2, um, min^-1.
std::string plain_unit(std::string_view unit) {
  constexpr std::u32string_view raised = U"⁰¹²³⁴⁵⁶⁷⁸⁹";
  std::string plain;
  bool power = false;  // within raised digits
  for (const char32_t c : code_points(unit)) {
    const std::size_t digit = raised.find(c);
    const bool is_raised = digit != std::u32string_view::npos || c == U'⁻';
    if (is_raised && !power) plain += '^';
    power = is_raised;
    if (digit != std::u32string_view::npos) {
      plain += static_cast<char>('0' + digit);
    } else if (c == U'⁻') {
      plain += '-';
    } else if (c == U'·' || c == U'⋅') {
      plain += '*';
    } else if (c == U'µ' || c == U'μ') {
      plain += 'u';
    } else if (c != U' ') {
      plain += utf8(std::u32string(1, c));
    }
  }
  return plain;
}

}  // namespace

std::string plain_quantity(const std::string& text) {
  const auto literal = parse_literal(text);
  const auto number = read_number(text, std::min(text.find_first_not_of(' '), text.size()));
  if (!literal || !number || number->end >= text.size()) return text;
  const std::size_t start = text.find_first_not_of(' ');
  std::string digits = text.substr(start, number->end - start);
  while (digits.ends_with(' ')) digits.pop_back();
  const std::string unit = plain_unit(std::string_view(text).substr(number->end));
  if (unit.empty()) return text;
  const std::string plain = digits + (unit.starts_with('/') ? "" : " ") + unit;
  const auto again = parse_literal(plain);
  const bool same = again && again->si == literal->si && again->dimension == literal->dimension;
  return same ? plain : text;
}

}  // namespace loadpath::project
