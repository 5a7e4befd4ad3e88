#include "lib/report/difference.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/why.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace loadpath::report {

namespace {

using account::Entry;
using project::Project;
using project::Step;
using Kind = Difference::Kind;

constexpr double alike = 1e-12;  // relative

bool same(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b || std::abs(a - b) <= alike * std::max(std::abs(a), std::abs(b));
}

/// Values of a sum that vanishes are rounding errors and differ from run to run: they are not a difference.
bool same(const Value& a, const Value& b) {
  if (a.si.size() != b.si.size()) return false;
  double size = 0.0;
  for (const double x : a.si) size = std::isfinite(x) ? std::max(size, std::abs(x)) : size;
  for (std::size_t i = 0; i < a.si.size(); ++i) {
    const bool nothing = a.si.size() > 1 && std::abs(a.si[i] - b.si[i]) <= alike * size;
    if (!nothing && !same(a.si[i], b.si[i])) return false;
  }
  return true;
}

/// The value, of a series the largest in magnitude; NaN if there is none.
double peak_of(const Value& value) {
  double peak = std::numeric_limits<double>::quiet_NaN();
  for (const double x : value.si) {
    if (std::isnan(peak) || std::abs(x) > std::abs(peak)) peak = x;
  }
  return peak;
}

std::optional<double> relative(double before, double after) {
  if (!std::isfinite(before) || !std::isfinite(after) || before == 0.0) return std::nullopt;
  return (after - before) / before;
}

/// Two numbers in one unit, with enough digits to distinguish them.
std::pair<std::string, std::string> texts_of(double before, double after, const std::string& unit) {
  std::pair<std::string, std::string> texts;
  for (const int digits : {6, 10, 15}) {
    texts = {format_quantity(before, unit, digits), format_quantity(after, unit, digits)};
    if (texts.first != texts.second) break;
  }
  return texts;
}

Kind kind_of(const Entry& entry, bool is_input) {
  if (!is_input) return Kind::result;
  if (entry.origin.searched) return Kind::chosen;
  return entry.origin.text.text().starts_with("=") ? Kind::taken : Kind::given;
}

std::string text_of(const Entry& entry) {
  if (!entry.word.empty()) return entry.word;
  const std::string text = format_quantity(peak_of(entry.values()), entry.unit);
  return entry.values().is_series() ? "peak " + text : text;
}

/// Nothing if both say the same.
std::optional<Difference> difference_of(const Entry& before, const Entry& after, bool is_input) {
  const bool words = !before.word.empty() || !after.word.empty();
  if (words ? before.word == after.word : same(before.values(), after.values())) return std::nullopt;
  Difference found{kind_of(after, is_input), after.path, text_of(before),
                   text_of(after),           {},         before.brief || after.brief};
  if (words) return found;
  const double was = peak_of(before.values()), is = peak_of(after.values());
  std::tie(found.before, found.after) = texts_of(was, is, after.unit);
  if (before.values().is_series() || after.values().is_series()) {
    const bool in_between = found.before == found.after;
    found.before = "peak " + found.before, found.after = "peak " + found.after;
    if (in_between) found.after += ", elsewhere other";
  }
  found.relative = relative(was, is);
  return found;
}

/// Entries by their paths, removed ones at the end. Most keep their positions.
void compare(const std::vector<Entry>& before, const std::vector<Entry>& after, bool is_input,
             std::vector<Difference>& found) {
  std::map<std::string_view, const Entry*> old;
  for (const Entry& e : before) old.emplace(e.path, &e);
  std::map<std::string_view, const Entry*> now;
  for (const Entry& e : after) {
    now.emplace(e.path, &e);
    const auto was = old.find(e.path);
    if (was == old.end()) {
      found.push_back({kind_of(e, is_input), e.path, "", text_of(e), {}, e.brief});
    } else if (auto difference = difference_of(*was->second, e, is_input)) {
      found.push_back(std::move(*difference));
    }
  }
  for (const Entry& e : before) {
    if (now.count(e.path) == 0) found.push_back({kind_of(e, is_input), e.path, text_of(e), "", {}, e.brief});
  }
}

using Typed = std::map<std::string, project::Typed>;

/// Typed texts other than fields: rows of tables, reasons of accepted modes. Those that a search found are not typed.
void compare_typed(const Typed& before, const Typed& after, const std::string& prefix, std::vector<Difference>& found) {
  const auto text_in = [](const Typed& all, const std::string& key) {
    const auto at = all.find(key);
    return at == all.end() ? std::string() : at->second.text;
  };
  std::map<std::string, int> keys;
  for (const auto* all : {&before, &after}) {
    for (const auto& [key, typed] : *all) keys[key] = 1;
  }
  for (const auto& [key, one] : keys) {
    if (text_in(before, key) != text_in(after, key))
      found.push_back({Kind::given, prefix + key, text_in(before, key), text_in(after, key), {}, true});
  }
}

std::string word_of(account::State state) { return account::shown(state).text(); }

/// "yield by u_tau", empty if no mode decides.
std::string deciding_words(const account::Modes& modes) {
  const auto mode = deciding(modes);
  if (!mode) return {};
  return mode->governs.empty() ? mode->id : mode->id + " by " + mode->governs;
}

void compare_modes(const account::Modes& before, const account::Modes& after, std::vector<Difference>& found) {
  const auto find_in = [](const account::Modes& all, const std::string& id) -> const account::Mode* {
    const auto at = std::find_if(all.begin(), all.end(), [&](const account::Mode& m) { return m.id == id; });
    return at == all.end() ? nullptr : &*at;
  };
  for (const account::Mode& mode : after) {
    const account::Mode* const was = find_in(before, mode.id);
    if (was == nullptr || was->state != mode.state)
      found.push_back({Kind::state, mode.id, was == nullptr ? "" : word_of(was->state), word_of(mode.state), {}, true});
  }
  for (const account::Mode& mode : before) {
    if (find_in(after, mode.id) == nullptr) found.push_back({Kind::state, mode.id, word_of(mode.state), "", {}, true});
  }
  if (deciding_words(before) != deciding_words(after))
    found.push_back({Kind::decides, "", deciding_words(before), deciding_words(after), {}, true});
  for (const account::Mode& mode : after) {
    const account::Mode* const was = find_in(before, mode.id);
    if (was == nullptr || !was->utilisation || !mode.utilisation || same(*was->utilisation, *mode.utilisation))
      continue;
    const auto [a, b] = texts_of(*was->utilisation, *mode.utilisation, "-");
    found.push_back({Kind::utilisation, mode.id, a, b, relative(*was->utilisation, *mode.utilisation), true});
  }
}

void compare_words(const std::string& name, const std::string& before, const std::string& after,
                   std::vector<Difference>& found) {
  if (before != after) found.push_back({Kind::heading, name, before, after, {}, true});
}

std::vector<Difference> differences_of(const Step& before, const Step& after) {
  std::vector<Difference> found;
  compare_words("title", before.input().title, after.input().title, found);
  compare_words("note", before.input().note, after.input().note, found);
  compare_words("body", before.input().body.text, after.input().body.text, found);
  compare_words("calculator", before.input().calculator->id, after.input().calculator->id, found);
  compare_typed(before.input().rows, after.input().rows, "", found);
  compare_typed(before.input().accepted, after.input().accepted, "accept.", found);
  compare_typed(before.input().because, after.input().because, "because.", found);
  compare(before.account().inputs, after.account().inputs, true, found);
  std::stable_sort(found.begin(), found.end(),
                   [](const Difference& a, const Difference& b) { return a.kind < b.kind; });
  compare_modes(before.account().modes, after.account().modes, found);
  compare(before.account().results, after.account().results, false, found);
  return found;
}

StepDifference whole(const Step& step, StepDifference::Change change) {
  StepDifference whole;
  whole.change = change;
  whole.name = step.name();
  whole.title = step.input().title.empty() ? step.input().calculator->title : step.input().title;
  whole.calculator = step.input().calculator->id;
  whole.state = word_of(account::overall(step.account().modes));
  return whole;
}

std::vector<Difference> heading_of(const Project& before, const Project& after) {
  std::map<std::string, std::pair<std::string, std::string>> texts;
  texts["title"] = {before.title, after.title};
  for (const auto& [key, text] : before.meta) texts[key].first = text;
  for (const auto& [key, text] : after.meta) texts[key].second = text;
  std::vector<Difference> found;
  for (const auto& [key, both] : texts) compare_words(key, both.first, both.second, found);
  return found;
}

}  // namespace

std::string word(Kind kind) {
  switch (kind) {
    case Kind::heading:
      return "heading";
    case Kind::given:
      return "input";
    case Kind::taken:
      return "taken";
    case Kind::chosen:
      return "chosen";
    case Kind::state:
      return "verdict";
    case Kind::decides:
      return "decides";
    case Kind::utilisation:
      return "utilisation";
    case Kind::result:
      return "result";
  }
  return "";
}

ProjectDifference difference_of(const Project& before, const Project& after) {
  ProjectDifference found;
  found.before = word_of(account::overall(project::modes(before)));
  found.after = word_of(account::overall(project::modes(after)));
  found.heading = heading_of(before, after);
  for (const auto& step : after.steps) {
    const Step* const was = before.find(step->name());
    StepDifference one = whole(*step, was == nullptr ? StepDifference::Change::added : StepDifference::Change::changed);
    if (was != nullptr) one.differences = differences_of(*was, *step);
    if (was == nullptr || !one.differences.empty()) found.steps.push_back(std::move(one));
  }
  for (const auto& step : before.steps) {
    if (after.find(step->name()) == nullptr) found.steps.push_back(whole(*step, StepDifference::Change::removed));
  }
  return found;
}

}  // namespace loadpath::report
