#include "lib/report/brief/names.hpp"

#include "lib/formula/formula.hpp"
#include "lib/formula/names.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/appendix.hpp"
#include "lib/report/columns.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/summary/summary.hpp"
#include "lib/report/worked.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace loadpath::report {

using account::Entry;

namespace {

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The end of ", gear 1" that begins there: one of two elements, without which their rows look the same; npos if
/// another text follows.
std::size_t end_of_element(std::string_view name, std::size_t comma) {
  constexpr auto letters = "abcdefghijklmnopqrstuvwxyz", digits = "0123456789";
  if (comma >= name.size()) return std::string::npos;
  const std::size_t word = comma + 2, blank = name.find_first_not_of(letters, word);
  if (blank == std::string::npos || blank == word || name[blank] != ' ') return std::string::npos;
  const std::size_t end = std::min(name.size(), name.find_first_not_of(digits, blank + 1));
  const bool is_last = end == name.size() || name[end] == ';' || name[end] == ',' || name.substr(end).starts_with(" (");
  return end > blank + 1 && is_last ? end : std::string::npos;
}

/// "revolute, slot: radius of the pin": the types of joints that have the input are no name.
void drop_joint_types(std::string& name) {
  for (const char* type : {"revolute", "prismatic", "rolling", "inner joint"}) {
    const std::size_t colon = name.starts_with(type) ? name.find(": ") : std::string::npos;
    if (colon != std::string::npos) name.erase(0, colon + 2);
  }
}

/// "O: first link" of "joints.O.links.first": one of a pair belongs to the element whose pair it is. Empty if it is of
/// no pair.
std::string name_in_pair(const std::string& path) {
  const std::size_t which = path.rfind('.');
  if (which == std::string::npos || which == 0) return {};
  const std::size_t pair = path.rfind('.', which - 1);
  if (pair == std::string::npos || pair == 0) return {};
  const std::string nouns = path.substr(pair + 1, which - pair - 1);
  const bool is_pair = nouns == "links" || nouns == "points" || nouns == "mass_points" || nouns == "radii";
  const std::string place = path.substr(which + 1);
  if (!is_pair || (place != "first" && place != "second")) return {};
  const std::string owner = owner_of(path.substr(0, which)) + ": ";
  if (nouns == "radii") return owner + "radius of the " + place + " link";
  return owner + place + " " + spoken(nouns.substr(0, nouns.size() - 1));
}

}  // namespace

std::string with_greek(std::string_view words) {
  std::string text;
  while (!words.empty()) {
    std::size_t end = 0;
    while (end < words.size() && is_of_name(words[end])) ++end;
    const std::string_view name = words.substr(0, end);
    if (end == 0)
      text += words.front();
    else
      text += formula::symbol(name).base.greek != nullptr ? formula::symbol_plain(name) : std::string(name);
    words.remove_prefix(std::max<std::size_t>(end, 1));
  }
  return text;
}

std::string short_name(const Entry& entry) {
  if (std::string pair = name_in_pair(entry.path); !pair.empty()) return pair;
  std::string name = with_greek(say("{1}", entry.doc).text());
  drop_joint_types(name);
  const std::size_t comma = name.find(", ");
  const std::size_t end = std::min({name.find(" ("), name.find(':'), name.find(';'), comma});
  const std::size_t element = end == comma ? end_of_element(name, comma) : std::string::npos;
  if (end != std::string::npos) name.resize(std::min(name.size(), element == std::string::npos ? end : element));
  const std::string owner = owner_of(entry.path);
  return owner.empty() ? name : owner + ": " + name;
}

std::string short_symbol(const std::string& path) { return formula::symbol_plain(named_symbol(path).symbol); }

std::string unbroken(std::string text) {
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at)) text.replace(at, 1, "\u00A0");
  return text;
}

namespace {

bool is_typed(const Entry& entry) { return entry.origin.text.text() == say("given").text(); }

/// "belts" of "= belts.n_2", "shaft" of "= 2*shaft.T": the step that a value comes from; empty if it names none.
std::string origin_step(const std::string& text) {
  for (std::size_t dot = text.find('.'); dot != std::string::npos; dot = text.find('.', dot + 1)) {
    std::size_t begin = dot;
    while (begin > 0 && is_of_name(text[begin - 1])) --begin;
    const bool is_number = std::isdigit(static_cast<unsigned char>(text[begin])) != 0;
    if (begin < dot && !is_number) return text.substr(begin, dot - begin);
  }
  return {};
}

}  // namespace

namespace {

/// "template slider crank"
std::string spoken_template(const Message& origin) {
  return origin.id == "template {1}" ? spoken(origin.text()) : origin.text();
}

}  // namespace

std::string short_value(const Entry& entry) {
  constexpr int digits = 5, short_digits = 4;
  if (!entry.word.empty()) return entry.origin.sources.empty() ? spoken(entry.word) : entry.word;
  if (entry.values().si.empty()) return {};
  const bool is_series = entry.values().is_series();
  const double si = is_series ? largest(entry.values()).value : entry.values().si.front();
  if (!is_series && is_safety(entry)) return unbroken(safety_number(si));
  const bool as_typed = !is_series && is_typed(entry) && std::isfinite(si);
  std::string text = as_typed ? format_quantity(si, entry.unit, digits) : short_quantity(si, entry.unit);
  if (std::isfinite(si) && text.find('e') < text.find(' '))  // "2e7 mm⁴"
    text = formula::quantity_plain(written({si, entry.unit, as_typed ? digits : short_digits}));
  if (text.starts_with('-')) text.replace(0, 1, "\u2212");
  return unbroken(std::move(text));
}

std::string titled(const project::Project& project, const std::string& component, double most_letters) {
  constexpr std::string_view article = "The ";
  std::string title;
  for (const auto& step : project.steps) {
    if (component_name(*step) != component) continue;
    if (!title.empty() || step->input().title.empty()) return component;
    title = step->input().title;
  }
  const auto has_title = [&](const auto& step) { return step->input().title == title; };
  if (std::ranges::count_if(project.steps, has_title) > 1) return component;
  if (title.starts_with(article)) title = capitalised(title.substr(article.size()));
  return title.empty() || letters_of(title) > most_letters ? component : title;
}

bool comes_from_step(const Entry& entry) {
  const std::string text = entry.origin.text.text();
  return text.starts_with("=") && !origin_step(text).empty() && origin_step(text) != "tables";
}

std::string short_origin(const Entry& entry) {
  std::string text = spoken_template(entry.origin.text);
  text.resize(std::min({text.size(), text.find("; "), text.find(", "), text.find(": "), text.find(" with ")}));
  if (text.starts_with(say("given").text())) return say("given").text();
  const std::string step = origin_step(text);
  if (text.starts_with("=") && !step.empty()) return say("from {1}", spoken(step)).text();
  if (!entry.origin.sources.empty()) text += " [" + entry.origin.sources.front() + "]";
  return text;
}

}  // namespace loadpath::report
