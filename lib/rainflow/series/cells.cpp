#include "lib/rainflow/series/cells.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace loadpath::rainflow {

namespace {

/// What std::from_chars gives for up to 15 digits with a point and no exponent: both whole numbers are doubles, and
/// their quotient is rounded once. None of any other text.
std::optional<double> short_number(std::string_view text) {
  constexpr std::array<double, 16> tens{1,   1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  if (text.empty() || text.size() >= tens.size() || text.front() == '.') return std::nullopt;
  std::uint64_t digits = 0;
  std::size_t decimals = 0, point = text.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto digit = static_cast<unsigned>(text[i] - '0');
    if (digit <= 9) {
      digits = 10 * digits + digit;
    } else if (text[i] == '.' && point == text.size()) {
      point = i, decimals = text.size() - i - 1;
    } else {
      return std::nullopt;
    }
  }
  const double size = static_cast<double>(digits) / tens[decimals];
  return negative ? -size : size;
}

/// All of the text as a finite number, with a decimal point.
std::optional<double> pointed_number(std::string_view text) {
  if (const auto value = short_number(text)) return value;
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  double x = 0.0;
  const auto [behind, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (behind != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range)
    x = std::strtod(std::string(text).c_str(), nullptr);  // distinguishes 0 from inf
  else if (error != std::errc{})
    return std::nullopt;
  return std::isfinite(x) ? std::optional(x) : std::nullopt;
}

/// "1,5" as "1.5"; empty unless a comma is the only mark.
std::string with_point(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || text.find_first_not_of("0123456789+-eE,") != std::string_view::npos) return {};
  std::string pointed(text);
  pointed[comma] = '.';
  return pointed;
}

/// Whether blanks part numbers with decimal commas: "0,5 1,25".
bool has_decimal_commas(std::string_view line) {
  const auto fields = fields_of(line, blanks);
  return fields.size() > 1 && std::all_of(fields.begin(), fields.end(), [](const std::string& field) {
           return field.find(',') != std::string::npos && pointed_number(with_point(field));
         });
}

}  // namespace

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

std::string_view take_field(std::string_view& line, char separator) {
  if (separator == blanks) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  }
  const std::size_t quoted = !line.empty() && line.front() == '"' ? line.find('"', 1) : 0;
  const std::size_t from = quoted == std::string_view::npos ? 0 : quoted;
  std::size_t end = from;
  if (separator == blanks) {
    while (end < line.size() && !is_blank(line[end])) ++end;
  } else {
    end = std::min(line.find(separator, from), line.size());
  }
  const std::string_view field = line.substr(0, end);
  line.remove_prefix(std::min(end + 1, line.size()));
  return trimmed(field);
}

std::vector<std::string> fields_of(std::string_view line, char separator) {
  std::vector<std::string> fields;
  const bool ends_open = separator != blanks && !line.empty() && line.back() == separator;
  if (separator == blanks) {
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  }
  while (!line.empty()) fields.emplace_back(take_field(line, separator));
  if (ends_open) fields.emplace_back();
  return fields;
}

char separator_of(std::string_view line) {
  if (line.find_first_of("\t;") == std::string_view::npos && has_decimal_commas(line)) return blanks;
  for (const char candidate : {'\t', ';', ','}) {
    if (line.find(candidate) != std::string_view::npos) return candidate;
  }
  return blanks;
}

std::optional<double> number_of(std::string_view text, char separator) {
  if (const auto value = pointed_number(text)) return value;
  if (separator == ',') return std::nullopt;
  const std::string pointed = with_point(text);
  return pointed.empty() ? std::nullopt : pointed_number(pointed);
}

Heading heading_of(std::string_view text) {
  text = trimmed(text);
  const std::size_t open = text.find_first_of("[("), close = text.find_last_of("])");
  if (open == std::string_view::npos || close != text.size() - 1 || close < open) return {std::string(text), ""};
  const std::string_view unit = trimmed(text.substr(open + 1, close - open - 1));
  return {std::string(trimmed(text.substr(0, open))), unit == "-" || unit == "1" ? "" : std::string(unit)};
}

}  // namespace loadpath::rainflow
