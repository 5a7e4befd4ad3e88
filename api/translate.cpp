#include "api/translate.hpp"

#include "lib/account/conclusion.hpp"
#include "lib/account/mode.hpp"
#include "lib/export/unit_name.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/project/sweep/columns.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <thread>
#include <tuple>

namespace loadpath::api {

static_assert(static_cast<int>(State::fail) == static_cast<int>(account::State::fail) &&
                  static_cast<int>(State::not_covered) == static_cast<int>(account::State::not_covered) &&
                  static_cast<int>(State::pass) == static_cast<int>(account::State::pass) &&
                  static_cast<double>(State::refused) == account::refused_state &&
                  static_cast<double>(State::absent) == account::absent_state,
              "the numbers of states are handed out");

Sources sources_of(const project::Project& project, Sources own) {
  for (const project::NamedFile& file : project.files) own.emplace(file.name, file.text);
  return own;
}

std::vector<Issue> issues_of(const std::vector<loadpath::Issue>& issues) {
  std::vector<Issue> all;
  all.reserve(issues.size());
  for (const loadpath::Issue& issue : issues)
    all.push_back({issue.place.file, issue.place.line, issue.place.column, issue.place.length, issue.key,
                   issue.message.text(), issue.hint.text(), issue.severity == Severity::error});
  std::stable_sort(all.begin(), all.end(), [](const Issue& a, const Issue& b) {
    return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
  });
  return all;
}

void refuse_errors(const std::vector<loadpath::Issue>& issues, const Sources& sources) {
  if (!has_errors(issues)) return;
  std::string text = render(issues, [&](const std::string& file) {
    const auto found = sources.find(file);
    return found == sources.end() ? std::string() : found->second;
  });
  while (text.ends_with('\n')) text.pop_back();
  throw Error(text, issues_of(issues));
}

void refuse(const Message& message, const Message& hint) {
  Issue issue;
  issue.message = message.text();
  issue.help = hint.text();
  throw Error(hint.empty() ? issue.message : issue.message + "\n  = help: " + issue.help, {issue});
}

void refuse_name(std::string_view id, std::string_view name, const std::vector<std::string>& known) {
  refuse(say(id, name), did_you_mean(name, known, there_is(known)));
}

Role role_of(loadpath::Role role) {
  switch (role) {
    case loadpath::Role::input:
      return Role::input;
    case loadpath::Role::check:
      return Role::check;
    case loadpath::Role::limit:
      return Role::limit;
    case loadpath::Role::result:
      break;
  }
  return Role::result;
}

std::string kind_of(const Dimension& dimension, Kind kind) {
  if (kind == Kind::energy) return "energy";
  if (kind == Kind::difference) return "temperature difference";
  return name_of(dimension);
}

std::string si_name(const Dimension& dimension) {
  const std::string unit = exports::unit_name(dimension);
  return unit.empty() ? "1" : unit;
}

namespace {

Quantity quantity_of(const account::Entry& entry, const project::Step& step, const std::string& prefix) {
  Quantity q;
  const Value& value = entry.values();
  const FieldInfo* const field = step.field(entry.path);
  q.name = prefix + entry.path;
  q.meaning = entry.doc;
  q.role = role_of(entry.role);
  q.word = entry.word;
  q.unit = entry.unit;
  if (!entry.word.empty()) {
    q.kind = "word";
    q.text = entry.word;
    return q;
  }
  q.kind = kind_of(value.signature.dimension, field == nullptr ? Kind::plain : field->kind);
  q.si_unit = si_name(value.signature.dimension);
  q.reason = entry.missing.text();
  if (value.is_series()) {
    q.series = value.si;
    q.axis = value.signature.axis->name();
    q.positions = value.signature.axis->at.values();
    q.text = std::to_string(q.series.size()) + " values over " + q.axis;
    return q;
  }
  if (!value.si.empty()) q.value = value.si[0];
  if (std::isnan(q.value) && q.reason.empty()) q.reason = "not available";
  q.text = format_quantity(q.value, entry.unit);
  return q;
}

Mode mode_of(const account::Mode& mode) {
  Mode m;
  m.step = mode.step;
  m.id = mode.id;
  m.meaning = mode.title.text();
  m.state = static_cast<State>(mode.state);
  m.group = account::key(account::group_of(mode));
  if (mode.utilisation) m.utilisation = *mode.utilisation;
  m.governs = mode.governs;
  m.reason = account::reason(mode).text();
  return m;
}

Check check_of(const account::Verdict& verdict) {
  Check check;
  check.step = verdict.step;
  check.name = verdict.symbol;
  check.meaning = verdict.meaning.text();
  if (const auto* value = std::get_if<account::Quantity>(&verdict.value)) check.value = value->si;
  check.bound = verdict.bound.text();
  check.state = static_cast<State>(verdict.state);
  return check;
}

}  // namespace

Solution solution_of(project::Project& project, std::vector<loadpath::Issue> issues, const Sources& sources,
                     const std::string& step_left_out) {
  project::solve(project, issues, {.pictures = false, .formulas = false});
  refuse_errors(issues, sources);
  Solution solution;
  for (const auto& step : project.steps) {
    const std::string prefix = step->name() == step_left_out ? std::string() : step->name() + ".";
    for (const auto* list : {&step->account().inputs, &step->account().results}) {
      for (const account::Entry& entry : *list) solution.quantities.push_back(quantity_of(entry, *step, prefix));
    }
  }
  const account::Modes modes = project::modes(project);
  for (const account::Mode& mode : account::in_order(modes)) solution.modes.push_back(mode_of(mode));
  for (const account::Verdict& verdict : project::verdicts(project)) solution.checks.push_back(check_of(verdict));
  solution.warnings = issues_of(issues);
  solution.state = static_cast<State>(account::overall(modes));
  solution.headline = account::word(account::conclude(modes).headline);
  solution.verdict = account::scope(modes).text();
  solution.passes = account::passes(modes);
  return solution;
}

Column column_of(const project::SweptInput& input) {
  return {input.name,
          input.words.empty() ? si_name(input.dimension) : "1",
          input.unit.empty() ? "-" : input.unit,
          input.words,
          {}};
}

Column column_of(const project::SweptResult& result) {
  return {result.name, si_name(result.dimension), result.unit.empty() ? "-" : result.unit, {}, {}};
}

std::vector<Refused> in_order(std::vector<Refused> all) {
  std::sort(all.begin(), all.end(), [](const Refused& a, const Refused& b) { return a.first < b.first; });
  return all;
}

unsigned threads_for(unsigned jobs) { return jobs != 0 ? jobs : std::max(1U, std::thread::hardware_concurrency()); }

namespace {

template <class All>
auto* found_in(All& all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

template <class All>
const auto& one_of(const All& all, std::string_view name) {
  const auto* const found = found_in(all, name);
  if (found != nullptr) return *found;
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const auto& one : all) names.push_back(one.name);
  refuse_name("'{1}' does not exist", name, names);
}

}  // namespace

std::string word_of(State state) {
  if (state == State::refused) return "refused";
  if (state == State::absent) return "absent";
  return account::word(static_cast<account::State>(state)).text();
}

const Quantity* Solution::find(std::string_view name) const { return found_in(quantities, name); }
const Quantity& Solution::operator[](std::string_view name) const { return one_of(quantities, name); }
const Column* Sweep::find(std::string_view name) const { return found_in(columns, name); }
const Column& Sweep::operator[](std::string_view name) const { return one_of(columns, name); }

}  // namespace loadpath::api
