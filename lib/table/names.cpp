#include "lib/table/names.hpp"

#include "lib/text/issue.hpp"
#include "lib/text/utf8.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
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

/// A number of another size has nothing to do with the requested one.
bool is_near(double wanted, double other) {
  constexpr double most = 0.2;
  return std::fabs(wanted - other) <= most * std::max(wanted, other);
}

/// Among the names with the same letters in front and behind, the one with the nearest number; a name without letters
/// in front ("1.0038") is treated as a misspelling.
std::string near_number(std::string_view name, const std::vector<std::string>& names) {
  const Numbered wanted = numbered(name);
  if (std::isnan(wanted.number) || wanted.letters.empty()) return {};
  std::tuple least{true, std::numeric_limits<double>::infinity(), true};
  std::string found;
  for (const std::string& candidate : names) {
    const Numbered other = numbered(candidate);
    if (!is_of_series(wanted, other)) continue;
    if (other.digits != wanted.digits && !is_near(wanted.number, other.number)) continue;
    if (far(wanted, other) < least) least = far(wanted, other), found = candidate;
  }
  return found;
}

/// "RHS 100x50x6.3": the letters "rhs" and the numbers 100, 50 and 6.3; of a name of another form no numbers.
struct Size {
  std::u32string letters;
  std::vector<double> numbers;
};

double number_of(std::u32string_view digits) {
  double number = 0.0, unit = 1.0;
  bool is_fraction = false;
  for (const char32_t c : digits) {
    if (c == U'.') {
      is_fraction = true;
      continue;
    }
    number = 10.0 * number + static_cast<double>(c - U'0');
    if (is_fraction) unit *= 10.0;
  }
  return number / unit;
}

Size size_of(std::string_view name) {
  const std::u32string text = folded(name);
  const auto first = std::find_if(text.begin(), text.end(), is_digit);
  Size size{{text.begin(), first}, {}};
  for (auto from = first; from != text.end();) {
    const auto end = std::find_if_not(from, text.end(), [](char32_t c) { return is_digit(c) || c == U'.'; });
    const bool is_last = end == text.end();
    if (from == end || (!is_last && (*end != U'x' || end + 1 == text.end()))) return {text, {}};
    size.numbers.push_back(number_of(std::u32string(from, end)));
    from = is_last ? end : end + 1;
  }
  return size;
}

/// Whether two sizes are of one series, "IPE 210" and "IPE 120"; the numbers of bearings and materials are not sizes.
bool is_of_series(const Size& wanted, const Size& other) {
  const bool is_size = !wanted.numbers.empty() && (!wanted.letters.empty() || wanted.numbers.size() > 1);
  return is_size && other.letters == wanted.letters && other.numbers.size() == wanted.numbers.size();
}

bool is_near(const Size& wanted, const Size& other) {
  const auto differing = std::mismatch(wanted.numbers.begin(), wanted.numbers.end(), other.numbers.begin());
  return differing.first == wanted.numbers.end() || is_near(*differing.first, *differing.second);
}

/// The sizes of a series next below and next above one that it does not have.
std::vector<std::string> neighbours(const Size& wanted, const std::vector<std::string>& series) {
  std::string below, above;
  Size low, high;
  for (const std::string& candidate : series) {
    const Size other = size_of(candidate);
    if (!is_near(wanted, other)) continue;
    if (other.numbers < wanted.numbers && (below.empty() || low.numbers < other.numbers))
      below = candidate, low = other;
    if (wanted.numbers < other.numbers && (above.empty() || other.numbers < high.numbers))
      above = candidate, high = other;
  }
  std::vector<std::string> found;
  if (!below.empty()) found.push_back(below);
  if (!above.empty()) found.push_back(above);
  return found;
}

/// Names of the same characters in another order, or with some more or fewer: instead of one digit, any other may be
/// meant.
std::vector<std::string> misspelt(std::string_view name, const std::vector<std::string>& names) {
  const auto sorted = [](std::string_view of) {
    std::u32string text = folded(of);
    std::sort(text.begin(), text.end());
    return text;
  };
  const std::u32string wanted = sorted(name);
  std::vector<std::string> found;
  for (const std::string& candidate : names) {
    const std::u32string characters = sorted(candidate);
    const bool has_all = std::includes(characters.begin(), characters.end(), wanted.begin(), wanted.end());
    const bool has_none_else = std::includes(wanted.begin(), wanted.end(), characters.begin(), characters.end());
    if (has_all || has_none_else) found.push_back(candidate);
  }
  return found;
}

/// Whether a name has digits and points only: "6208", "1.0038".
bool is_number(std::string_view name) {
  const std::u32string text = folded(name);
  return std::all_of(text.begin(), text.end(), [](char32_t c) { return is_digit(c) || c == U'.'; });
}

}  // namespace

std::u32string folded(std::string_view name) {
  std::u32string points = code_points(name);
  std::erase_if(points, [](char32_t c) { return c == U' ' || c == U'-'; });
  std::transform(points.begin(), points.end(), points.begin(), lower_case);
  return points;
}

std::vector<std::string> near_names(std::string_view name, const std::vector<std::string>& names) {
  const Size wanted = size_of(name);
  std::vector<std::string> series;
  std::copy_if(names.begin(), names.end(), std::back_inserter(series),
               [&](const std::string& candidate) { return is_of_series(wanted, size_of(candidate)); });
  if (auto found = neighbours(wanted, series); !found.empty()) return found;
  std::string near = series.empty() ? near_number(name, names) : "";
  if (near.empty()) near = nearest(name, series.empty() && !is_number(name) ? names : misspelt(name, names));
  return near.empty() ? std::vector<std::string>{} : std::vector{near};
}

}  // namespace loadpath::table
