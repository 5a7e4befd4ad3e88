#include "lib/account/rows.hpp"
#include "lib/project/run/judgement.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::project {

namespace {

/// "at 202.7 deg of lever: crank angle"
Message at_place(const Extreme& extreme, const Axis& axis) {
  return say("at {1} ({2})", format_quantity(extreme.at, axis.unit, 5), axis.name());
}

/// "covered from 0.2 to 3", "passes up to 9", "covered if at least 1.2": the requirement of a limit on its value.
Message bounds_of(const FieldInfo& field) {
  const std::string low = format_quantity(without_margin(field, field.bounds.low), field.unit);
  const std::string high = format_quantity(without_margin(field, field.bounds.high), field.unit);
  const Message verb = field.is_criterion ? say("passes") : say("covered");
  if (is_open_above(field)) return say("{1} if at least {2}", verb, low);
  if (std::isinf(field.bounds.low)) return say("{1} up to {2}", verb, high);
  return say("{1} from {2} to {3}", verb, low, high);
}

/// Why a check has no value: the size does not settle, a table does not reach so far, an input is missing.
struct Gap {
  account::State state;
  Message why;
};

Gap gap_of(const Evaluation& evaluation) {
  const Message& table_gap = evaluation.inputs().table_gap();
  if (evaluation.is_settled() && !table_gap.empty()) return {account::State::not_covered, table_gap};
  return {account::State::not_available, evaluation.missing()};
}

account::Verdict check_verdict(const Evaluation& evaluation, const ResultSeries& series) {
  const Axis* const axis = evaluation.axis();
  const Extreme largest = axis == nullptr ? Extreme{series.value.si[0], 0.0, 0} : maximum(series.value);
  account::Verdict v{.step = evaluation.step().name(),
                     .symbol = series.path,
                     .meaning = say(series.field->doc),
                     .value = account::Quantity{largest.value, "-", 4},
                     .bound = say("passes at 1 or less")};
  if (std::isnan(largest.value)) {
    Gap gap = gap_of(evaluation);
    v.state = gap.state;
    v.note = std::move(gap.why);
    return v;
  }
  v.state = account::state_of_check(largest.value);
  v.utilisation = largest.value;
  if (axis == nullptr) return v;
  v.note = at_place(largest, *axis);
  v.at = account::Quantity{largest.at, axis->unit, 3};
  return v;
}

account::Verdict limit_verdict(const Evaluation& evaluation, const ResultSeries& series) {
  const FieldInfo& field = *series.field;
  const double worst = account::farthest_from(field.bounds, series.value.si);
  return {.step = evaluation.step().name(),
          .symbol = series.path,
          .meaning = say(field.doc),
          .value = account::Quantity{worst, field.unit, 4},
          .bound = bounds_of(field),
          .state = std::isnan(worst) ? account::State::not_available
                                     : account::state_of_limit(field.bounds, field.is_criterion, worst)};
}

/// The verdict of a check if nothing could be computed.
account::Verdict open_verdict(const Evaluation& evaluation, const FieldInfo& check) {
  Gap gap = gap_of(evaluation);
  return {.step = evaluation.step().name(),
          .symbol = check.key,
          .meaning = say(check.doc),
          .value = gap.state,
          .bound = say("passes at 1 or less"),
          .state = gap.state,
          .note = std::move(gap.why)};
}

/// If a limit is violated, a check without a value is not a gap in the input: the formula is outside its range.
void excuse_uncovered(std::vector<account::Verdict>& all) {
  if (std::none_of(all.begin(), all.end(), [](const auto& v) { return v.state == account::State::not_covered; }))
    return;
  for (account::Verdict& v : all) {
    if (v.state == account::State::not_available && v.note.empty()) v.state = account::State::not_covered;
  }
}

}  // namespace

void add_verdicts(const Evaluation& evaluation, const Results& results, std::vector<account::Verdict>& verdicts) {
  for (const ResultSeries& series : results.series) {
    if (!is_reported(evaluation, series)) continue;
    if (series.field->role == Role::check) verdicts.push_back(check_verdict(evaluation, series));
    if (series.field->role == Role::limit) verdicts.push_back(limit_verdict(evaluation, series));
  }
  excuse_uncovered(verdicts);
  if (!results.series.empty()) return;
  for (const FieldInfo& field : evaluation.calculator().result->fields) {
    if (field.role == Role::check && evaluation.is_asked(field)) verdicts.push_back(open_verdict(evaluation, field));
  }
}

}  // namespace loadpath::project
