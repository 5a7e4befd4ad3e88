#include "lib/project/run/account.hpp"

#include "lib/project/run/derivation.hpp"
#include "lib/project/run/judgement.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

/// The choices that occur, in their order: "strength", or over a series "strength, stiffness".
std::string words_of(const FieldInfo& field, const std::vector<double>& si) {
  std::string words;
  for (std::size_t k = 0; k < field.choices.size(); ++k) {
    if (std::find(si.begin(), si.end(), static_cast<double>(k)) == si.end()) continue;
    words += (words.empty() ? "" : ", ") + std::string(field.choices[k].key);
  }
  return words;
}

/// Rows that were taken from other steps, or found.
void add_rows(const Inputs& inputs, std::vector<Entry>& entries) {
  for (const auto& [group, row] : inputs.rows()) {
    const Origin* const origin = inputs.origin_of_row(group);
    if (origin == nullptr || (row.text.empty() && !origin->searched)) continue;
    Value none;  // value of a search without result
    if (row.text.empty()) none.si = {std::nan("")};
    entries.insert(entries.begin(), {group, "row of the tables", "-", Role::input, none, *origin, row.text});
  }
}

std::vector<Entry> input_entries_of(const Inputs& inputs, const WeighedValues& weighed) {
  std::vector<Entry> entries = input_entries(
      inputs.record(), [&](const std::string& path, const Leaf& leaf) { return inputs.origin_of(path, leaf); });
  for (Entry& entry : entries) {
    const ComputedInput* const computed = inputs.find_computed(entry.path);
    if (computed != nullptr && !computed->is_whole) entry.value = computed->value;  // the record has a whole series
    if (const auto reason = weighed.reasons.find(entry.path); reason != weighed.reasons.end())
      entry.origin.text = say("{1}; {2}", entry.origin.text, reason->second);
  }
  add_rows(inputs, entries);
  return entries;
}

/// Whether a result belongs to a record that other steps take.
bool is_handed_over(const Evaluation& evaluation, const std::string& path) {
  const FieldInfo* const head = find_field(evaluation.calculator().result->fields, path.substr(0, path.find('.')));
  return head != nullptr && head->is_handed_over;
}

/// Names and formulas in the calculation: the section that it found, the equation of a path; and words of records: of a
/// drive that was picked.
void add_words(const Evaluation& evaluation, std::vector<Entry>& entries) {
  const Record& result = evaluation.result();
  for (const FieldInfo& field : evaluation.calculator().result->fields) {
    const bool is_text = field.type == FieldInfo::Type::name || field.type == FieldInfo::Type::formula;
    if (!is_text || field.text(result.data.get()).empty()) continue;
    entries.push_back({field.key, field.doc, "-", field.role, {}, {}, std::string(field.text(result.data.get()))});
  }
  for_each_leaf(result, [&](const std::string& path, const Leaf& leaf) {
    if (leaf.field->get != nullptr || !is_handed_over(evaluation, path)) return;
    Entry entry{path, leaf.field->doc, "-", leaf.field->role, {}, {}, word_of(leaf)};
    entry.handed_over = true;
    if (!entry.word.empty()) entries.push_back(std::move(entry));
  });
}

void add_numbers(const Evaluation& evaluation, const Results& results, std::vector<Entry>& entries) {
  const auto& units = evaluation.step().input().display;
  for (const ResultSeries& series : results.series) {
    if (!is_reported(evaluation, series)) continue;
    const FieldInfo& field = *series.field;
    const auto display = units.find(series.path);
    const std::string unit = display == units.end() ? field.unit : display->second;
    Entry entry{series.path, field.doc, unit, field.role, series.value, {}, ""};
    entry.brief = series.path == field.key;  // otherwise from an element of a list
    entry.handed_over = is_handed_over(evaluation, series.path);
    if (field.type == FieldInfo::Type::choice) entry.word = words_of(field, series.value.si);
    entries.push_back(std::move(entry));
  }
}

/// A search result passes the assessed checks only: modes not assessed because of a missing input are reported with it.
void report_not_assessed(Account& account) {
  std::string names;
  for (const account::Mode& mode : account.modes) {
    if (mode.kind == ModeKind::strength && mode.state == account::State::not_judged && !mode.wants.empty())
      names += (names.empty() ? "" : ", ") + mode.id;
  }
  if (names.empty()) return;
  for (Entry& entry : account.inputs) {
    if (entry.origin.searched) entry.origin.text = say("{1}; not assessed: {2}", entry.origin.text, names);
  }
}

}  // namespace

void fill_account(const Evaluation& evaluation, const Findings& found, const Wanted& wanted, Account& account) {
  const Governing& governing = found.governing;
  const Record &input = evaluation.record(), &result = evaluation.result();
  const Axis* const axis = evaluation.axis();
  account.inputs = input_entries_of(evaluation.inputs(), found.weighed);
  if (governing.is_evaluated) add_words(evaluation, account.results);
  add_numbers(evaluation, found.results, account.results);
  add_verdicts(evaluation, found.results, account.verdicts);
  for (account::Verdict& verdict : account.verdicts) {
    const auto compared = found.governing.compared.find(verdict.symbol);
    if (compared != found.governing.compared.end()) verdict.compared = compared->second;
  }
  add_modes(evaluation, found.results, found.weighed, account.verdicts, account.modes);
  report_not_assessed(account);
  for (const Line& line : governing.trace.lines()) account.scopes.insert(line.scope);
  if (!governing.is_evaluated) return;
  if (wanted.formulas) account.derivation = derive(governing.trace, input, result);
  if (axis != nullptr) {
    account.governing = say("at {1} ({2}), where the governing check is largest",
                            format_quantity(axis->at[governing.position], axis->unit, 5), axis->name());
  }
  const auto figures = evaluation.calculator().figures;
  if (wanted.pictures && figures != nullptr) account.figures = figures(input.data.get(), result.data.get());
}

}  // namespace loadpath::project
