#include "lib/formula/formula.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/summary/summary.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace loadpath::report {

namespace {

using account::Group;
using account::Mode;
using account::Modes;
using account::State;

/// The record that a step takes there, "lever.cycle" of cycle = "=lever.cycle"; empty if none.
std::string taken_by(const project::Step& step, const std::string& key) {
  const auto& records = step.input().reading.records;
  const auto taken = std::ranges::find(records, key, &project::Taken::path);
  return taken == records.end() ? "" : taken->source;
}

enum class Wording { typed, spoken };

/// "the allowable deflection v_adm": its meaning without remarks, and its symbol.
std::string spoken_input(const project::Step& step, const std::string& key) {
  const FieldInfo* const field = find_field_at(step.input().calculator->input->fields, key);
  if (field == nullptr) return key;
  std::string meaning = say("{1}", field->doc).text();
  meaning.resize(
      std::min({meaning.size(), meaning.find(" ("), meaning.find(':'), meaning.find(';'), meaning.find(", ")}));
  const std::string text = say("the {1}", meaning).text();
  return is_word(field->key) ? text : text + " " + formula::symbol_plain(field->key);
}

/// The inputs that a mode waits for.
std::string wanted_inputs(const project::Project& project, const Mode& mode, Wording wording) {
  const project::Step* const step = project.find(mode.step);
  if (wording == Wording::typed || step == nullptr) return mode.wants;
  std::string all;
  for (const std::string& key : listed_keys(mode.wants)) all += (all.empty() ? "" : ", ") + spoken_input(*step, key);
  return all;
}

/// The step to add, or that of its calculator which the project has already: not one that assesses another part.
std::string step_to_add(const project::Project& project, const Mode& mode, Wording wording) {
  const std::string id = mode.judge.empty() ? mode.add : mode.judge;
  if (id.empty()) return {};
  const std::string key = mode.takes.substr(0, mode.takes.find(' '));
  for (const auto& step : project.steps) {
    if (step->input().calculator->id != id || step->name() == mode.step) continue;
    if (mode.takes.empty()) return say("assess it in step '{1}' ({2})", step->name(), id).text();
    const std::string taken = taken_by(*step, key);
    if (taken.empty() && wording == Wording::spoken)
      return say("assess it in {1} ({2})", spoken(step->name()), id).text();
    if (taken.empty()) return say("let {1} take {2}", step->name(), mode.takes).text();
    if (mode.takes.find("\"=" + taken + "\"") != std::string::npos) return say("see {1}", step->name()).text();
  }
  return mode.takes.empty() || wording == Wording::spoken ? say("add a step of {1}", id).text()
                                                          : say("add a step of {1} with {2}", id, mode.takes).text();
}

/// Whether the mode waits for the reason of a value; its note says why the value is doubted.
bool waits_for_reason(const Mode& mode) { return mode.wants.starts_with("because.") && !mode.note.empty(); }

/// "x_l = 1.4, covered up to 1.3: effective key length / shaft diameter"; empty if no single limit decides.
std::string out_of_range(const project::Project& project, const Mode& mode) {
  const project::Step* const step = project.find(mode.step);
  if (step == nullptr || mode.governs.empty()) return {};
  const auto& rows = step->account().verdicts;
  const auto row = std::ranges::find(rows, mode.governs, &account::Verdict::symbol);
  const auto* const value = row == rows.end() ? nullptr : std::get_if<account::Quantity>(&row->value);
  if (value == nullptr) return {};
  return say("{1} = {2}, {3}: {4}", row->symbol, short_quantity(value->si, value->unit), row->bound, row->meaning)
      .text();
}

/// Whether an input activates a check: a limit that results are compared with.
bool is_limit(const Calculator& calculator, const std::string& key) {
  return calculator.result != nullptr && std::ranges::any_of(calculator.result->fields, [&](const FieldInfo& field) {
           const auto asking = listed_keys(field.asked_by);
           return field.role == Role::check && std::ranges::find(asking, key) != asking.end();
         });
}

/// " (L_nh = 75300 h)": the result that a wanted input would be compared with, the only value in its unit; else empty.
std::string result_without(const project::Project& project, const Mode& mode) {
  const project::Step* const step = project.find(mode.step);
  if (step == nullptr) return {};
  for (const std::string& key : listed_keys(mode.wants)) {
    const FieldInfo* const wanted = find_field(step->input().calculator->input->fields, key);
    const bool in_unit =
        wanted != nullptr && wanted->type == FieldInfo::Type::quantity && std::string_view(wanted->unit) != "-";
    if (!in_unit || !is_limit(*step->input().calculator, key)) continue;
    const account::Entry* found = nullptr;
    bool is_only = true;
    for (const account::Entry& entry : step->account().results) {
      const bool is_like = entry.unit == wanted->unit && entry.values().signature.dimension == wanted->dimension;
      if (!is_like || entry.values().si.size() != 1 || std::isnan(entry.values().si[0])) continue;
      is_only = is_only && (found == nullptr || found->values().si == entry.values().si);
      found = &entry;
    }
    if (found != nullptr && is_only)
      return say(" ({1} = {2})", found->path, short_quantity(found->values().si[0], found->unit)).text();
  }
  return {};
}

/// The remedy for a mode that is not assessed.
std::string action_of(const project::Project& project, const Mode& mode, Wording wording) {
  if (mode.state == State::not_covered || mode.state == State::not_available) {
    if (!mode.note.empty()) return mode.note.text();
    const std::string range = mode.state == State::not_covered ? out_of_range(project, mode) : "";
    const std::string what =
        range.empty() ? say("method not valid").text() : say("method not valid: {1}", range).text();
    return mode.use.empty() ? what : say("{1}; replace with a step of {2}", what, mode.use).text();
  }
  if (waits_for_reason(mode)) return mode.note.text();
  const std::string add = step_to_add(project, mode, wording), wanted = wanted_inputs(project, mode, wording);
  if (!wanted.empty() && add.empty()) return say("give {1}{2}", wanted, result_without(project, mode)).text();
  if (!wanted.empty()) return say("give {1}, or {2}", wanted, add).text();
  if (!add.empty()) return add;
  if (!mode.use.empty()) return say("replace with a step of {1}", mode.use).text();
  return account::reason(mode).text();
}

/// Whether a mode has no result because a search of its step has none, which is stated above.
bool follows_from_search(const Modes& modes, const Mode& mode) {
  return mode.state == State::not_available && std::ranges::any_of(modes, [&](const Mode& other) {
           return other.subject == account::Subject::search && other.step == mode.step &&
                  other.note.text() == mode.note.text();
         });
}

/// Adds a title to those of a step.
void add_title(Gap& gap, const Mode& mode) {
  const std::string step = spoken(mode.step), title = plain_title(mode);
  auto known = std::ranges::find(gap.modes, step, [](const auto& of_step) { return of_step.first; });
  if (known == gap.modes.end()) known = gap.modes.insert(gap.modes.end(), {step, {}});
  if (std::ranges::find(known->second, title) == known->second.end()) known->second.push_back(title);
}

/// A mode with one name in several steps is named with its step.
std::vector<std::string> names_with_steps(const std::vector<std::pair<std::string, std::vector<std::string>>>& titles,
                                          bool several) {
  std::vector<std::string> names;
  for (const auto& [title, steps] : titles) {
    std::string name = title, separator = " (";
    for (const std::string& step : steps) {
      if (!several) break;
      name.append(separator).append(step);
      separator = ", ";
    }
    names.push_back(several && !steps.empty() ? name + ")" : name);
  }
  return names;
}

void add_hint(Remedy hint, std::vector<Remedy>& hints) {
  if (!hint.typed.empty() && std::ranges::find(hints, hint.typed, &Remedy::typed) == hints.end())
    hints.push_back(std::move(hint));
}

/// In both wordings.
template <class Text>
Remedy remedy(const Text& text) {
  return {text(Wording::typed), text(Wording::spoken)};
}

/// The modes that a step in place of this one would assess.
std::string replacing(const project::Project& project, const Modes& modes) {
  constexpr std::size_t most = 3;
  std::map<std::string, std::vector<std::string>> titles;  // by "shaft.torsion with shaft.design"
  std::string first;
  for (const Mode& mode : modes) {
    const bool waits = mode.state == State::open || mode.state == State::not_judged;
    const project::Step* const step = project.find(mode.step);
    if (!waits || mode.use.empty() || step == nullptr) continue;
    const std::string key = step->input().calculator->id + std::string(" with ") + mode.use;
    if (first.empty() && mode.state == State::open) first = key;
    std::string title = account::short_title(mode);
    auto& all = titles[key];
    if (std::ranges::find(all, title) == all.end()) all.push_back(std::move(title));
  }
  if (first.empty()) return {};
  std::string names;
  for (std::size_t i = 0; i < std::min(most, titles[first].size()); ++i)
    names += (i == 0 ? "" : ", ") + titles[first][i];
  return say("replace {1} ({2})", first, names).text();
}

std::vector<Remedy> hints_of(const project::Project& project, const Modes& sorted, bool several) {
  std::vector<Remedy> hints;
  for (const Mode& mode : sorted) {
    if (mode.state != State::open || mode.wants.empty()) continue;
    const std::string step = several ? spoken(mode.step) + ", " : "", title = account::short_title(mode);
    add_hint(remedy([&](Wording wording) {
               return say("give {1} ({2}{3})", wanted_inputs(project, mode, wording), step, title).text();
             }),
             hints);
  }
  add_hint(remedy([&](Wording) { return replacing(project, sorted); }), hints);
  for (const Mode& mode : sorted) {
    if (mode.state != State::open || !mode.wants.empty()) continue;
    if (step_to_add(project, mode, Wording::typed).empty()) continue;
    add_hint(remedy([&](Wording wording) {
               return say("{1} ({2})", step_to_add(project, mode, wording), account::short_title(mode)).text();
             }),
             hints);
  }
  return hints;
}

/// "a, b", or "a, left; b" where a name has a comma of its own.
std::string listed(const std::vector<std::string>& names) {
  const bool has_comma =
      std::ranges::any_of(names, [](const std::string& name) { return name.find(',') != std::string::npos; });
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : has_comma ? "; " : ", ") + name;
  return all;
}

}  // namespace

std::string modes_text(const Gap& gap) {
  std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> groups;  // steps, titles
  for (const auto& [step, titles] : gap.modes) {
    const auto same = std::ranges::find(groups, titles, [](const auto& group) { return group.second; });
    if (same == groups.end())
      groups.push_back({{step}, titles});
    else
      same->first.push_back(step);
  }
  std::string all;
  for (const auto& [names, titles] : groups) all += (all.empty() ? "" : "; ") + listed(names) + ": " + listed(titles);
  return all;
}

std::vector<Gap> gaps_of(const project::Project& project, const Modes& modes, Group group) {
  std::vector<Gap> gaps;
  for (const Mode& mode : account::in_order(modes)) {
    if (mode.subject == account::Subject::search || follows_from_search(modes, mode)) continue;
    const bool is_check = mode.subject == account::Subject::input && group == Group::needs_input;
    if (!is_check && (mode.subject != account::Subject::mode || account::group_of(mode) != group)) continue;
    const Remedy action = remedy([&](Wording wording) {
      return group == Group::needs_input ? action_of(project, mode, wording) : spoken(mode.step);
    });
    auto known = std::ranges::find(gaps, action.typed, [](const Gap& gap) { return gap.action.typed; });
    if (known == gaps.end()) known = gaps.insert(gaps.end(), {{}, action});
    add_title(*known, mode);
  }
  if (group != Group::needs_input) {
    for (Gap& gap : gaps) gap.action = {};
  }
  return gaps;
}

namespace {

using Titles = std::vector<std::pair<std::string, std::vector<std::string>>>;  // with their steps

void add_mode(const Mode& mode, Titles& titles) {
  const std::string title = plain_title(mode);
  auto known = std::ranges::find(titles, title, [](const auto& named) { return named.first; });
  const bool first = account::short_title(mode) == "fatigue";
  if (known == titles.end()) known = titles.insert(first ? titles.begin() : titles.end(), {title, {}});
  known->second.push_back(spoken(mode.step));
}

}  // namespace

NotConsidered not_considered(const project::Project& project, const Modes& modes, bool several) {
  NotConsidered all;
  Titles assessable, rest, others;
  const Modes sorted = account::in_order(modes);
  for (const Mode& mode : sorted) {
    if (mode.state != State::open) continue;
    const bool is_strength = mode.kind == ModeKind::strength;
    add_mode(mode, is_strength ? (mode.is_assessable ? assessable : rest) : others);
    if (!is_strength) ++all.others;
  }
  assessable.insert(assessable.end(), rest.begin(), rest.end());
  all.names = names_with_steps(assessable, several);
  all.other_names = names_with_steps(others, several);
  all.hints = hints_of(project, sorted, several);
  return all;
}

std::string other_modes(const NotConsidered& open) {
  constexpr std::size_t most_named = 3;
  const std::size_t named = std::min(most_named, open.other_names.size());
  std::string text;
  for (std::size_t i = 0; i < named; ++i) text += (i == 0 ? "" : ", ") + open.other_names[i];
  if (const std::size_t rest = open.other_names.size() - named; rest > 0) text += "; " + std::to_string(rest) + " more";
  return text;
}

}  // namespace loadpath::report
