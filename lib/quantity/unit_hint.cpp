#include "lib/quantity/unit_hint.hpp"

#include "lib/quantity/number/cursor.hpp"
#include "lib/quantity/unit_table.hpp"

#include <algorithm>

namespace loadpath {
namespace {

const std::vector<std::string>& usual_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> texts;
    for (const UnitName& name : all_unit_names(true)) texts.push_back(name.text);
    return texts;
  }();
  return names;
}

bool differ_in_case_only(std::string_view a, std::string_view b) {
  const std::u32string x = code_points(a), y = code_points(b);
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](char32_t p, char32_t q) { return lower_case(p) == lower_case(q); });
}

bool has_latin(std::string_view name) { return std::any_of(name.begin(), name.end(), is_latin); }
bool has_cyrillic(std::string_view name) {
  return std::any_of(name.begin(), name.end(), [](char c) { return c == '\xD0' || c == '\xD1'; });
}

/// A name with look-alike letters of the other script, as the unit that it resembles; else empty.
std::string in_one_script(std::string_view name) {
  constexpr std::u32string_view latin = U"ABCEHKMOPTXaceopxyk", cyrillic = U"АВСЕНКМОРТХасеорхук";
  static_assert(latin.size() == cyrillic.size());
  const auto exchanged = [&](std::u32string_view from, std::u32string_view to) {
    std::u32string points = code_points(name);
    for (char32_t& p : points)
      if (const std::size_t at = from.find(p); at != std::u32string_view::npos) p = to[at];
    const std::string text = utf8(points);
    return find_unit(text).row != nullptr ? text : std::string();
  };
  const std::string text = exchanged(latin, cyrillic);
  return text.empty() ? exchanged(cyrillic, latin) : text;
}

/// The unit that a misspelt name resembles most, of any dimension; else empty.
std::string unit_meant(std::string_view name) {
  std::string meant = in_one_script(name);
  if (meant.empty()) meant = nearest(name, usual_names());
  if (meant.empty() || !differ_in_case_only(meant, name))
    if (std::string pair = split(name); !pair.empty()) meant = std::move(pair);
  return meant;
}

/// The dimension of a unit as `unit_meant` writes it: a name, or a product of two.
Dimension dimension_of(const std::string& unit) {
  const std::size_t star = unit.find('*');
  const Dimension first = find_unit(unit.substr(0, star)).row->dimension;
  return star == std::string::npos ? first : first * find_unit(unit.substr(star + 1)).row->dimension;
}

std::string trimmed(std::string_view text) {
  const std::size_t from = std::min(text.find_first_not_of(' '), text.size());
  return std::string(text.substr(from, text.find_last_not_of(' ') + 1 - from));
}

}  // namespace

Message unknown_unit(std::string_view name) {
  const bool mixed = has_latin(name) && has_cyrillic(name);
  return mixed ? say("the unit '{1}' mixes Latin and Cyrillic letters", name) : say("unknown unit '{1}'", name);
}

/// "OO" of "12OO rpm".
static bool is_letter_for_zero(std::string_view name) {
  return !name.empty() && name.find_first_not_of("Oo") == std::string_view::npos;
}

Message unknown_unit_hint(std::string_view name) {
  if (is_letter_for_zero(name)) return say("write the digit 0, not the letter {1}", name.substr(0, 1));
  const std::string meant = unit_meant(name);
  return meant.empty() ? Message{} : say("did you mean '{1}'?", meant);
}

Message unknown_unit_hint(std::string_view name, const Dimension& dimension, std::string_view usual) {
  if (is_letter_for_zero(name)) return unknown_unit_hint(name);
  std::vector<std::string> names;
  for (const UnitName& unit : all_unit_names(true))
    if (unit.row->dimension == dimension) names.push_back(unit.text);
  const std::vector<std::string> near = all_nearest(name, names);
  if (!near.empty() && differ_in_case_only(near.front(), name)) return say("did you mean '{1}'?", near.front());
  if (std::find(near.begin(), near.end(), usual) != near.end()) return say("did you mean '{1}'?", usual);
  const std::string meant = unit_meant(name);
  if (meant.empty() || dimension_of(meant) == dimension) return unknown_unit_hint(name);
  return say("write a unit such as {1}", usual);
}

std::string split(std::string_view name) {
  constexpr Dimension time = Dimension::of(0, 0, 1);  // kmh, mins, lbs are not products with h and s
  for (std::size_t at = character_length(name, 0); at < name.size(); at += character_length(name, at)) {
    const FoundUnit first = find_unit(name.substr(0, at)), second = find_unit(name.substr(at));
    if (first.row == nullptr || second.row == nullptr) continue;
    if (second.row->dimension == time || second.row->dimension == first.row->dimension) continue;
    return std::string(name.substr(0, at)) + "*" + std::string(name.substr(at));
  }
  return {};
}

Message one_division(std::string_view above, std::string_view below, char sign, std::string_view rest) {
  const std::string a = trimmed(above), b = trimmed(below), c = trimmed(rest.substr(0, rest.find(')')));
  const bool readable = c.find_first_of("/(") == std::string::npos && !b.empty() && !c.empty();
  if (!readable) return say("write one '/' and parentheses, as in 'W/(m*K)'");
  const std::string top = a.empty() ? "1" : a, quotient = top + "/(" + b + "*" + c + ")";
  if (sign == '/') return say("write '{1}'", quotient);
  return say("write '{1}' or '{2}'", quotient, (top == "1" ? c : top + "*" + c) + "/" + b);
}

}  // namespace loadpath
