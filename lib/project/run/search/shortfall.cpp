#include "lib/project/run/search/shortfall.hpp"

#include "lib/account/rows.hpp"
#include "lib/numerics/magnitude.hpp"
#include "lib/project/modes.hpp"
#include "lib/project/run/search/evaluated_rows.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace loadpath::project {

namespace {

/// With enough digits to show that it is above 1.
std::string beyond_one(double utilisation) {
  int precision = 4;
  while (precision < 12 && format_number(utilisation, precision) == "1") ++precision;
  return format_number(utilisation, precision);
}

/// The ratio of a value to the bound that it exceeds; 1 within them.
double excess_over(const Range& bounds, double si) {
  if (std::isnan(si)) return std::numeric_limits<double>::infinity();
  if (bounds.holds(si)) return 1.0;
  const double bound = si > bounds.high ? bounds.high : bounds.low;
  if (!(si * bound > 0.0)) return std::numeric_limits<double>::infinity();  // the other side of zero is far
  return std::max(1.0, std::max(si / bound, bound / si));
}

/// Whether a criterion leaves no range: two sizes must be equal.
bool requires_equality(const Range& bounds) { return bounds.high - bounds.low < 1e-3 * bounds.high; }

/// Adds the shortfall of a row of a list element.
void add_shortfall_of_element(const FieldInfo& row, double si, Shortfall& shortfall) {
  if (std::isnan(si)) return;  // the limits report a missing value
  double& most = row.role == Role::check || row.is_criterion ? shortfall.check : shortfall.limit;
  most = std::max(most, row.role == Role::check ? si : excess_over(row.bounds, si));
}

/// The path "seats.coupling.x_c" of an element as it was evaluated last.
std::string path_of(const Evaluation& evaluation, const FieldInfo& list, const Row& row) {
  return list.key + element_path(list, evaluation.result().data.get(), row.element) + "." + row.field->key;
}

CandidateFault fault_of_check(const std::string& path, double utilisation) {
  return {say("{1} = {2}", path, beyond_one(utilisation)), path, utilisation, "-"};
}

/// The range of a method is not a capacity: its ratio is not a utilisation, and has no unit.
CandidateFault fault_of_limit(const std::string& path, const FieldInfo& limit, double si) {
  const std::string unit = limit.unit == std::string("-") && !limit.is_criterion ? "" : limit.unit;
  return {say("{1} = {2}: {3}", path, format_quantity(si, limit.unit, 4), bound_message(limit, si)), path, si, unit};
}

/// The rows of the elements of lists, at every position.
void visit_lists(Evaluation& evaluation, const Passing& passing, const EvaluatedRows::Visit& visit) {
  const EvaluatedRows visited(evaluation, passing, visit);
}

/// The check in a list that is beyond 1 most, and beyond `most`; empty if none is.
CandidateFault fault_of_lists(Evaluation& evaluation, const Passing& passing, double most) {
  CandidateFault worst;
  visit_lists(evaluation, passing, [&](const FieldInfo& list, const Row& row, double si) {
    if (row.field->role != Role::check || !numerics::exceeds(si, most)) return;
    most = si;
    worst = fault_of_check(path_of(evaluation, list, row), most);
  });
  return worst;
}

/// The first limit in a list that is not kept, else why the first check there has no value; empty if there is none.
CandidateFault fault_of_listed_limits(Evaluation& evaluation, const Passing& passing) {
  CandidateFault outside, unknown;
  visit_lists(evaluation, passing, [&](const FieldInfo& list, const Row& row, double si) {
    const FieldInfo& f = *row.field;
    if (account::is_kept(f, si)) return;
    if (std::isnan(si) && unknown.text.empty()) unknown.text = say("{1} has no value", path_of(evaluation, list, row));
    if (!std::isnan(si) && f.role == Role::limit && outside.text.empty())
      outside = fault_of_limit(path_of(evaluation, list, row), f, si);
  });
  if (!outside.text.empty()) return outside;
  const Message& gap = evaluation.inputs().table_gap();
  return unknown.text.empty() || gap.empty() ? unknown : CandidateFault{gap};
}

/// The first check of the part without a value; empty if all have one.
Message check_without_value(Evaluation& evaluation, const Passing& passing) {
  for (const FieldInfo& f : evaluation.calculator().result->fields) {
    if (f.role != Role::check || f.where_set || !passing.counts({&f})) continue;
    if (std::isnan(evaluation.largest_result(f))) return say("{1} has no value", f.key);
  }
  return say("a check has no value: type the size in place of \"?\", and the run names it");
}

/// The first criterion, or limit of a method, that is not kept; empty if there is none.
CandidateFault fault_of_bounds(Evaluation& evaluation, Passing& passing, bool criteria) {
  for (const FieldInfo& f : evaluation.calculator().result->fields) {
    if (f.role != Role::limit || f.is_criterion != criteria || !passing.counts({&f})) continue;
    if (const auto bad = passing.first_outside(f))
      return std::isnan(*bad) ? CandidateFault{say("{1} is not available", f.key)} : fault_of_limit(f.key, f, *bad);
  }
  return {};
}

/// The first limit that is not kept, of the criteria before those of the methods.
CandidateFault fault_of_limits(Evaluation& evaluation, Passing& passing) {
  for (const bool criteria : {true, false}) {
    if (CandidateFault fault = fault_of_bounds(evaluation, passing, criteria); !fault.text.empty()) return fault;
  }
  if (CandidateFault listed = fault_of_listed_limits(evaluation, passing); !listed.text.empty()) return listed;
  const Message& gap = evaluation.inputs().table_gap();
  return {gap.empty() ? check_without_value(evaluation, passing) : gap};
}

/// The largest value of a check that is not passed; nothing if it is.
std::optional<double> failed_value(const EvaluatedRows& rows, const FieldInfo& check) {
  const double largest = rows.largest(check);
  return numerics::exceeds(largest, 1.0) ? std::optional(largest) : std::nullopt;
}

/// Whether a failure with both the smallest and the largest candidate does not improve with the largest.
bool is_unmoved(const FieldInfo& field, double with_smallest, double with_largest) {
  const double change = with_largest - with_smallest, rounding = 1e-9 * std::abs(with_largest);
  return field.role == Role::check ? change >= -rounding : std::abs(change) <= rounding;
}

/// "d_a = 49 mm, d_f = 47 mm": the inputs that a criterion compares, as they are set.
std::string compared_by(const Evaluation& evaluation, const FieldInfo& criterion) {
  std::string all;
  for (const std::string& key : listed_keys(criterion.asked_by)) {
    const FieldInfo* const field = find_field(evaluation.calculator().input->fields, key);
    if (field == nullptr || field->type != FieldInfo::Type::quantity) continue;
    const double si = evaluation.inputs().leaf(key).get();
    if (std::isfinite(si)) all += (all.empty() ? "" : ", ") + key + " = " + format_quantity(si, field->unit, 4);
  }
  return all;
}

}  // namespace

FailedValues failed_values(Evaluation& evaluation, Passing& passing) {
  FailedValues outside;
  const EvaluatedRows rows(evaluation, passing, [&](const FieldInfo&, const Row& row, double si) {
    if (std::isnan(si) || account::is_kept(*row.field, si)) return;
    const auto [known, is_new] = outside.emplace(row, si);
    if (!is_new && row.field->role == Role::check) known->second = std::max(known->second, si);
  });
  for (const FieldInfo& f : evaluation.calculator().result->fields) {
    if (!passing.counts({&f})) continue;
    const auto bad = f.role == Role::limit ? rows.first_outside(f) : failed_value(rows, f);
    if (bad && !std::isnan(*bad)) outside[{&f}] = *bad;
  }
  return outside;
}

FailedValues unmoved_values(const FailedValues& smaller, const FailedValues& larger) {
  FailedValues unmoved;
  for (const auto& [row, value] : larger) {
    const auto same = smaller.find(row);
    if (same != smaller.end() && is_unmoved(*row.field, same->second, value)) unmoved.emplace(row, value);
  }
  return unmoved;
}

/// A check without a value counts unless a limit explains it.
Shortfall shortfall_of_candidate(Evaluation& evaluation, Passing& passing) {
  Shortfall shortfall;
  bool missing = false;
  const EvaluatedRows rows(evaluation, passing, [&](const FieldInfo&, const Row& row, double si) {
    add_shortfall_of_element(*row.field, si, shortfall);
  });
  for (const FieldInfo& f : evaluation.calculator().result->fields) {
    if (!passing.counts({&f})) continue;
    if (f.role == Role::check) {
      const double largest = rows.largest(f);
      missing = missing || (std::isnan(largest) && !f.where_set);
      if (numerics::exceeds(largest, shortfall.check)) shortfall.check = largest;
    } else if (const auto bad = rows.first_outside(f)) {
      shortfall.limit = std::max(shortfall.limit, excess_over(f.bounds, *bad));
      if (!f.is_criterion) continue;
      shortfall.check = std::max(shortfall.check, shortfall.limit);
      shortfall.misfit = std::max(shortfall.misfit, requires_equality(f.bounds) ? Misfit::unequal : Misfit::beyond);
    }
  }
  if (missing && shortfall.limit <= 1.0) shortfall.check = std::numeric_limits<double>::infinity();
  return shortfall;
}

CandidateFault fault_of_candidate(Evaluation& evaluation, Passing& passing) {
  evaluation.settle_sizes();
  if (!evaluation.is_settled()) return {evaluation.unsettled()};
  if (const auto rule = passing.first_broken_rule()) return {evaluation.broken_rule(*rule).message};
  CandidateFault misfit = fault_of_bounds(evaluation, passing, true);  // what does not fit needs no strength
  if (misfit.number) return misfit;
  const EvaluatedRows rows(evaluation, passing);
  const FieldInfo* worst = nullptr;  // a check without a value may be so for a limit that is not kept
  double most = 1.0;
  for (const FieldInfo& f : evaluation.calculator().result->fields) {
    if (f.role != Role::check || !passing.counts({&f})) continue;
    const double largest = rows.largest(f);
    if (!numerics::exceeds(largest, most)) continue;
    worst = &f;
    most = largest;
  }
  if (CandidateFault listed = fault_of_lists(evaluation, passing, most); !listed.text.empty()) return listed;
  if (worst != nullptr) return fault_of_check(worst->key, most);
  return fault_of_limits(evaluation, passing);
}

Message fault_in_full(const Evaluation& evaluation, const CandidateFault& fault) {
  const FieldInfo* const row = find_field(evaluation.calculator().result->fields, fault.row);
  if (row == nullptr || (row->role != Role::check && !row->is_criterion)) return fault.text;
  const std::string compared = row->is_criterion ? compared_by(evaluation, *row) : "";
  if (compared.empty()) return say("{1} ({2})", fault.text, row->doc);
  return say("{1} ({2}: {3})", fault.text, row->doc, compared);
}

account::TriedSize tried_size(const Calculator& calculator, std::string name, std::optional<double> si,
                              CandidateFault fault) {
  account::TriedSize next{.name = std::move(name),
                          .si = si,
                          .fails = std::move(fault.row),
                          .number = fault.number,
                          .unit = std::move(fault.unit),
                          .reason = std::move(fault.text)};
  for (const ModeInfo& mode : calculator.modes) {
    const auto keys = listed_keys(mode.checks);
    const auto names = [&](const std::string& key) { return names_row(key, next.fails); };
    if (next.fails.empty() || std::none_of(keys.begin(), keys.end(), names)) continue;
    next.mode = mode.id;
    next.title = say(mode.title);
    break;
  }
  return next;
}

}  // namespace loadpath::project
