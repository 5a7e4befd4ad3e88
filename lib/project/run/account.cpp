// What a run has found, as an account.
#include "lib/project/run/derivation.hpp"
#include "lib/project/run/run.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

/// "at 202.7 deg of lever: crank angle"
Message at_place(const Extreme& extreme, const Axis& axis) {
  return say("at {1} ({2})", format_quantity(extreme.at, axis.unit, 5), axis.name());
}

/// "covered from 0.2 to 3", "passes up to 9": what a limit asks of its value.
Message bounds_of(const FieldInfo& field) {
  const std::string low = format_quantity(field.bounds.low, field.unit);
  const std::string high = format_quantity(field.bounds.high, field.unit);
  const Message verb = field.is_criterion ? say("passes") : say("covered");
  if (std::isinf(field.bounds.high)) return say("{1} from {2}", verb, low);
  if (std::isinf(field.bounds.low)) return say("{1} up to {2}", verb, high);
  return say("{1} from {2} to {3}", verb, low, high);
}

/// The choices that occur, in their order: "strength", or over a series "strength, stiffness".
std::string words_of(const FieldInfo& field, const std::vector<double>& si) {
  std::string words;
  for (std::size_t k = 0; k < field.choices.size(); ++k) {
    if (std::find(si.begin(), si.end(), static_cast<double>(k)) == si.end()) continue;
    words += (words.empty() ? "" : ", ") + std::string(field.choices[k].key);
  }
  return words;
}

}  // namespace

Value Run::value_of(const Column& column) const { return {{column.field->dimension, axis_}, column.si}; }

Origin Run::origin_of(const std::string& path, const Leaf& leaf) const {
  const auto known = origins_.find(path);
  if (known != origins_.end()) return known->second;
  for (const Input& input : inputs_) {
    if (input.path == path) return input.origin;
  }
  return plain_origin(step_.input().reading, path, leaf);
}

void Run::fill(const Wanted& wanted, Account& account) const {
  fill_inputs(account);
  fill_results(account);
  fill_verdicts(account);
  fill_modes(account);
  tell_unjudged(account);
  for (const Line& line : trace_.lines()) account.scopes.insert(line.scope);
  if (wanted.formulas && traced_) account.derivation = derive(trace_, record_, result_);
  if (axis_ != nullptr && traced_) {
    account.governing = say("at {1} ({2}), where the governing check is largest",
                            format_quantity(axis_->at[governing_], axis_->unit, 5), axis_->name());
  }
  if (wanted.pictures && traced_ && calculator_.figures != nullptr)
    account.figures = calculator_.figures(record_.data.get(), result_.data.get());
}

/// What was found has passed what is judged: what is not, for want of an input, is told with it.
void Run::tell_unjudged(Account& account) const {
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

/// Rows that were taken from other steps, or found.
void Run::fill_rows(Account& account) const {
  for (const auto& [group, row] : rows_) {
    const auto origin = origins_.find(group);
    if (origin == origins_.end() || (row.text.empty() && !origin->second.searched)) continue;
    Value none;  // of a search that has found nothing
    if (row.text.empty()) none.si = {std::nan("")};
    account.inputs.insert(account.inputs.begin(),
                          {group, "row of the tables", "-", Role::input, none, origin->second, row.text});
  }
}

void Run::fill_inputs(Account& account) const {
  account.inputs =
      input_entries(record_, [&](const std::string& path, const Leaf& leaf) { return origin_of(path, leaf); });
  for (Entry& entry : account.inputs) {
    for (const Input& input : inputs_) {
      if (input.path == entry.path) entry.value = input.value;
    }
  }
  for (Entry& entry : account.inputs) {
    if (const auto reason = reasons_.find(entry.path); reason != reasons_.end())
      entry.origin.text = say("{1}; {2}", entry.origin.text, reason->second);
  }
  fill_rows(account);
}

/// Whether a result is asked for, and is not one that the calculator has left unset.
bool Run::applies(const Column& column) const {
  if (!is_asked(*column.field)) return false;
  return !column.field->where_set ||
         std::any_of(column.si.begin(), column.si.end(), [](double x) { return !std::isnan(x); });
}

/// Whether a result is part of a record that other steps take whole.
bool Run::is_handed_over(const std::string& path) const {
  const FieldInfo* const head = find_field(calculator_.result->fields, path.substr(0, path.find('.')));
  return head != nullptr && head->is_handed_over;
}

/// What the records name: words of a drive that was picked.
void Run::fill_words_of_records(Account& account) const {
  for_each_leaf(result_, [&](const std::string& path, const Leaf& leaf) {
    if (leaf.field->get != nullptr || !is_handed_over(path)) return;
    Entry entry{path, leaf.field->doc, "-", leaf.field->role, {}, {}, word_of(leaf)};
    entry.handed_over = true;
    if (!entry.word.empty()) account.results.push_back(std::move(entry));
  });
}

void Run::fill_results(Account& account) const {
  for (const FieldInfo& field : calculator_.result->fields) {  // what the calculation names: the section that it found
    if (!traced_ || field.type != FieldInfo::Type::name || field.text(result_.data.get()).empty()) continue;
    account.results.push_back(
        {field.key, field.doc, "-", field.role, {}, {}, std::string(field.text(result_.data.get()))});
  }
  if (traced_) fill_words_of_records(account);
  for (const Column& column : columns_) {
    if (!applies(column)) continue;
    const auto display = step_.input().display.find(column.path);
    const std::string unit = display == step_.input().display.end() ? column.field->unit : display->second;
    Entry entry{column.path, column.field->doc, unit, column.field->role, value_of(column), {}, ""};
    entry.brief = column.path == column.field->key;  // else it is of an element of a list
    entry.handed_over = is_handed_over(column.path);
    if (column.field->type == FieldInfo::Type::choice) entry.word = words_of(*column.field, column.si);
    account.results.push_back(std::move(entry));
  }
}

/// Which of the inputs has no value somewhere; empty where all have.
Message Run::missing_input() const {
  if (!not_given_.empty()) return not_given_;
  for (const Input& input : inputs_) {
    if (std::any_of(input.value.si.begin(), input.value.si.end(), [](double x) { return std::isnan(x); })) {
      return say("'{1}' is not available: {2}", input.path, input.origin.text);
    }
  }
  return {};
}

account::Verdict Run::check_verdict(const Column& column) const {
  const Extreme largest = axis_ == nullptr ? Extreme{column.si[0], 0.0, 0} : maximum(value_of(column));
  const bool beyond_table = std::isnan(largest.value) && !missing_.empty();
  account::Verdict v{.step = step_.name(),
                     .symbol = column.path,
                     .meaning = say(column.field->doc),
                     .value = account::Quantity{largest.value, "-", 4},
                     .bound = say("passes at 1 or less"),
                     .state = beyond_table                ? account::State::not_covered
                              : std::isnan(largest.value) ? account::State::not_available
                                                          : account::state_of_check(largest.value)};
  if (std::isnan(largest.value))
    v.note = missing_.empty() ? missing_input() : missing_;
  else
    v.utilisation = largest.value;
  if (axis_ != nullptr && v.utilisation) v.note = at_place(largest, *axis_);
  return v;
}

account::Verdict Run::limit_verdict(const Column& column) const {
  const Range& bounds = column.field->bounds;
  const double worst = account::farthest_from(bounds, column.si);
  return {.step = step_.name(),
          .symbol = column.path,
          .meaning = say(column.field->doc),
          .value = account::Quantity{worst, column.field->unit, 4},
          .bound = bounds_of(*column.field),
          .state = std::isnan(worst) ? account::State::not_available
                                     : account::state_of_limit(bounds, column.field->is_criterion, worst)};
}

/// Where a limit is not kept, a check without a value is no gap in the input: the formula does not reach so far.
void Run::excuse_uncovered(Account& account) const {
  const auto& all = account.verdicts;
  if (std::none_of(all.begin(), all.end(), [](const auto& v) { return v.state == account::State::not_covered; }))
    return;
  for (account::Verdict& v : account.verdicts) {
    if (v.state == account::State::not_available && v.note.empty()) v.state = account::State::not_covered;
  }
}

void Run::fill_verdicts(Account& account) const {
  for (const Column& column : columns_) {
    if (!applies(column)) continue;
    if (column.field->role == Role::check) account.verdicts.push_back(check_verdict(column));
    if (column.field->role == Role::limit) account.verdicts.push_back(limit_verdict(column));
  }
  excuse_uncovered(account);
  if (!columns_.empty()) return;
  for (const FieldInfo& field : calculator_.result->fields) {  // nothing could be computed: say so check by check
    if (field.role != Role::check || !is_asked(field)) continue;
    const account::State state = missing_.empty() ? account::State::not_available : account::State::not_covered;
    account.verdicts.push_back({.step = step_.name(),
                                .symbol = field.key,
                                .meaning = say(field.doc),
                                .value = state,
                                .bound = say("passes at 1 or less"),
                                .state = state,
                                .note = missing_.empty() ? missing_input() : missing_});
  }
}

}  // namespace loadpath::project
