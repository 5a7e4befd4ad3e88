#include "lib/quantity/format.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/summary/summary.hpp"
#include "lib/report/why.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace loadpath::report {

namespace {

using account::Entry;
using project::Step;

/// Whether a path is the one of a placeholder: "cylinders.*.F" is that of every cylinder.
bool is_named(std::string_view path, std::string_view key) {
  const std::size_t star = key.find('*');
  if (star == std::string_view::npos) return path == key;
  return path.size() >= key.size() && path.starts_with(key.substr(0, star)) && path.ends_with(key.substr(star + 1));
}

double largest_of(const Entry& entry) {
  if (entry.values().si.empty()) return NAN;
  if (!entry.values().is_series()) return entry.values().si.front();
  return std::abs(largest(entry.values()).value);
}

/// The value of a placeholder, of results before inputs; empty where it is not known. "{b#}": without its unit;
/// "{drive.M!}": where it is not zero.
std::string value_of(const Step& step, std::string_view key) {
  const bool bare = key.ends_with('#'), nonzero = key.ends_with('!');
  if (bare || nonzero) key.remove_suffix(1);
  const Entry* best = nullptr;
  double most = NAN;
  for (const auto* entries : {&step.account().results, &step.account().inputs}) {
    for (const Entry& entry : *entries) {
      if (!is_named(entry.path, key)) continue;
      if (!entry.word.empty()) return entry.word;
      const double here = largest_of(entry);
      if (std::isnan(here) || std::abs(here) <= most) continue;
      most = here;
      best = &entry;
    }
    if (best != nullptr) break;
  }
  if (best != nullptr && nonzero && most == 0.0) return {};
  if (best != nullptr && bare) return format_number(in_unit(most, best->unit), 5);
  if (best != nullptr && best->role == Role::input && best->unit != "deg") return format_quantity(most, best->unit, 5);
  if (best != nullptr) return short_quantity(most, best->unit);
  return step.word(std::string(key));
}

/// The text with its placeholders filled; empty where one is not known.
std::string filled(const Step& step, std::string_view text) {
  std::string all;
  while (!text.empty()) {
    const std::size_t open = std::min(text.find('{'), text.size());
    all += text.substr(0, open);
    if (open == text.size()) return all;
    const std::size_t close = text.find('}', open);
    const std::string value = value_of(step, text.substr(open + 1, close - open - 1));
    if (value.empty()) return {};
    all += value;
    text.remove_prefix(close + 1);
  }
  return all;
}

/// The first of the phrases whose values are known; empty if there is none.
std::string phrase_of(const Step& step, std::string_view rest) {
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('|'), rest.size());
    if (std::string text = filled(step, rest.substr(0, end)); !text.empty()) return text;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return {};
}

/// Behind one another: a size may be broken behind a comma only.
std::string unbroken(std::string text) {
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1)) {
    if (at == 0 || text[at - 1] != ',') text.replace(at, 1, "\u00A0");
  }
  return text;
}

/// Whether the placeholders of a text are inputs that no search has found.
bool names_given(const Step& step, std::string_view text) {
  const auto& inputs = step.account().inputs;
  bool any = false;
  for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
    const std::string key(text.substr(open + 1, text.find_first_of("#!}", open) - open - 1));
    const auto input = std::ranges::find(inputs, key, &Entry::path);
    if (input != inputs.end() && input->origin.searched) return false;
    if (find_field_at(step.input().calculator->input->fields, key) == nullptr) return false;
    any = true;
  }
  return any;
}

/// The terms, between commas, of the first phrase whose values are known, as far as they are given.
void add_given_terms(const Step& step, std::string_view phrases, std::vector<std::string>& sizes) {
  std::string_view phrase = phrases.substr(0, phrases.find('|'));
  while (filled(step, phrase).empty() && phrase.size() < phrases.size()) {
    phrases.remove_prefix(phrase.size() + 1);
    phrase = phrases.substr(0, phrases.find('|'));
  }
  constexpr std::string_view comma = ", ";
  while (!phrase.empty()) {
    const std::size_t end = std::min(phrase.find(comma), phrase.size());
    const std::string_view term = phrase.substr(0, end);
    std::string text = names_given(step, term) ? filled(step, term) : std::string();
    if (!text.empty()) sizes.push_back(unbroken(std::move(text)));
    phrase.remove_prefix(std::min(end + comma.size(), phrase.size()));
  }
}

bool has_value(const Entry& entry) { return !entry.word.empty() || !std::isnan(largest_of(entry)); }

std::string sized_text(const Entry& entry) {
  if (!entry.word.empty()) return entry.word;
  const std::string value = format_quantity(largest_of(entry), entry.unit, 5), owner = owner_of(entry.path);
  return owner.empty() ? entry.path + " = " + value : owner + " " + value;
}

}  // namespace

namespace {

/// "segment 1" of "segments[1]", "point 2" of "over[2]": an element without a name.
std::string numbered_element(const std::string& element) {
  const std::size_t bracket = element.find('[');
  if (bracket == std::string::npos || !element.ends_with(']')) return element;
  std::string noun = element.substr(0, bracket);
  if (!noun.ends_with('s'))
    noun = "point";  // of a course or a law by points: "over[2]", "law[2]"
  else if (noun.ends_with("ies"))
    noun.replace(noun.size() - 3, 3, "y");
  else if (noun.ends_with("sses") || noun.ends_with("xes"))
    noun.resize(noun.size() - 2);
  else if (noun.ends_with('s'))
    noun.pop_back();
  return noun + " " + element.substr(bracket + 1, element.size() - bracket - 2);
}

/// What precedes the last element of a path, and that element.
std::pair<std::string, std::string> split_last(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos) return {"", path};
  return {path.substr(0, dot), path.substr(dot + 1)};
}

}  // namespace

std::string owner_of(const std::string& path) {
  const std::size_t last = path.rfind('.');
  if (last == std::string::npos) return {};
  const auto [above, element] = split_last(path.substr(0, last));
  const std::string own = numbered_element(element);
  const bool is_point = !element.ends_with(own) && own.starts_with("point ") && !above.empty();
  return is_point ? say("{1}, {2}", spoken(numbered_element(split_last(above).second)), own).text() : spoken(own);
}

std::vector<std::string> given_sizes(const Step& step) {
  std::vector<std::string> sizes;
  const auto& fields = step.input().calculator->input->fields;
  for (const Entry& entry : step.account().inputs) {
    const FieldInfo* const field = find_field_at(fields, entry.path);
    const bool is_size =
        field != nullptr && *field->searched_in != '\0' && !entry.origin.searched && entry.origin.sources.empty();
    if (is_size && has_value(entry)) sizes.push_back(unbroken(sized_text(entry)));
  }
  return sizes;
}

std::vector<std::string> declared_sizes(const Step& step) {
  std::vector<std::string> sizes;
  if (is_sized(step)) add_given_terms(step, step.input().calculator->headline, sizes);
  add_given_terms(step, step.input().calculator->details, sizes);
  return sizes;
}

std::string failed_mode_text(const account::TriedSize& tried) {
  if (tried.title.empty() || !tried.number) return tried.reason.text();
  if (tried.unit != "-") return tried.title.text() + " (" + tried.reason.text() + ")";
  return tried.title.text() + " " + utilisation_text(*tried.number);
}

std::string failure_text(const account::TriedSize& tried) { return tried.name + " fails: " + failed_mode_text(tried); }

bool describes_size(const Step& step) {
  const std::string_view headline = step.input().calculator->headline;
  const std::size_t open = headline.find('{');
  if (open == std::string_view::npos) return true;
  const std::size_t end = std::min(headline.find_first_of("#!}", open), headline.size());
  const std::string_view key = headline.substr(open + 1, end - open - 1);
  const auto& results = step.account().results;
  const auto result = std::ranges::find(results, key, &Entry::path);
  return result == results.end() || (!result->unit.empty() && result->unit != "-" && result->unit != "MPa");
}

bool is_sized(const Step& step) {
  return std::ranges::any_of(chosen(step.account()), [](const Entry* entry) { return has_value(*entry); });
}

std::vector<std::string> short_sizes(const Step& step) {
  std::vector<std::string> sizes;
  for (const Entry* entry : chosen(step.account())) {
    if (has_value(*entry)) sizes.push_back(unbroken(sized_text(*entry)));
  }
  if (!sizes.empty()) return sizes;
  if (std::string text = phrase_of(step, step.input().calculator->headline); !text.empty())
    sizes.push_back(unbroken(std::move(text)));
  return sizes;
}

std::string details_of(const Step& step) { return phrase_of(step, step.input().calculator->details); }

}  // namespace loadpath::report
