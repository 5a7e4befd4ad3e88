#include "lib/project/run/typed_values.hpp"

#include "lib/account/rows.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/because.hpp"
#include "lib/project/run/neighbours.hpp"
#include "lib/project/run/own_bounds.hpp"
#include "lib/project/run/source_values.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace loadpath::project {

namespace {

Message shown(const FieldInfo& field, double si) {
  if (field.type == FieldInfo::Type::choice) return say("{1}", field.choices[static_cast<std::size_t>(si)].key);
  return say("{1}", field.type == FieldInfo::Type::count ? format_number(si) : format_quantity(si, field.unit, 5));
}

double typed_value(const Evaluation& evaluation, const Neighbour& neighbour) {
  return largest_magnitude(evaluation.inputs().value_of(neighbour.path, neighbour.leaf));
}

/// By the digits of the text; for a value that is not typed only the rounding error.
double rounding_of(const Evaluation& evaluation, const Neighbour& neighbour) {
  const auto& typed = evaluation.step().input().reading.typed;
  const auto text = typed.find(neighbour.path);
  return relative_rounding(text == typed.end() ? "" : text->second.text);
}

/// The first of the typed values that is not usual.
double unusual_value(const Evaluation& evaluation, const Neighbour& neighbour) {
  const Value typed = evaluation.inputs().value_of(neighbour.path, neighbour.leaf);
  const Range& usual = neighbour.leaf.field->plausible;
  return *std::find_if(typed.si.begin(), typed.si.end(), [&](double x) { return !std::isnan(x) && !usual.holds(x); });
}

/// The excess of a value over its bound: "R_e = 960 MPa, above 225 MPa of the material 'S235JR'".
Message excess_of(const Evaluation& evaluation, const Neighbour& neighbour) {
  const FieldInfo& field = *neighbour.leaf.field;
  const double typed = typed_value(evaluation, neighbour), other = largest_magnitude(neighbour.value);
  if (field.type == FieldInfo::Type::choice)
    return say("{1} = {2} instead of {3} of {4}", neighbour.path, shown(field, typed), shown(field, other),
               neighbour.source);
  if (neighbour.kind == FieldRole::usual) return unusual(neighbour.path, field, unusual_value(evaluation, neighbour));
  if (neighbour.kind == FieldRole::either)
    return say("{1} = {2}, and {3} has {4}", neighbour.path, shown(field, typed), neighbour.source,
               shown(field, other));
  if (neighbour.is_unassessed) return say("{1} = {2} is not the result of a step", neighbour.path, shown(field, typed));
  if (neighbour.is_full)
    return say("{1} = {2} has next to no safety factor against {3}", neighbour.path, shown(field, typed),
               neighbour.source);
  return neighbour.kind == FieldRole::capacity ? say("{1} = {2}, above {3} of {4}", neighbour.path, shown(field, typed),
                                                     shown(field, other), neighbour.source)
                                               : say("{1} = {2}, below {3} of {4}", neighbour.path, shown(field, typed),
                                                     shown(field, other), neighbour.source);
}

/// All neighbours with a value, apart from derived bounds.
std::vector<Neighbour> all_neighbours(const Evaluation& evaluation, const Results& results, const Known& known) {
  std::vector<Neighbour> all = neighbours_of(evaluation, results, known);
  add_source_values(evaluation, known, all);
  std::erase_if(all, [](const Neighbour& neighbour) { return std::isnan(largest_magnitude(neighbour.value)); });
  return all;
}

/// The bound of the calculator that a typed value keeps; nothing of a bolder value, and of another neighbour.
std::optional<KeptBound> kept_bound(const Evaluation& evaluation, const Neighbour& neighbour) {
  if (!neighbour.of_bound) return std::nullopt;
  const KeptBound bound{neighbour.of_bound->bound,          neighbour.of_bound->element,        neighbour.kind,
                        typed_value(evaluation, neighbour), rounding_of(evaluation, neighbour), neighbour.value.si[0]};
  return keeps(bound, bound.value) ? std::optional(bound) : std::nullopt;
}

/// Notes with what a typed value is compared. A value of another step of the body that has a reason decides nothing.
void note_compared(const Evaluation& evaluation, const Neighbour& neighbour, WeighedValues& weighed) {
  const StepInput& step = evaluation.step().input();
  if (neighbour.is_of_body && reason_for(step, neighbour.path) != nullptr) return;
  const auto is_it = [&](const auto& one) { return one.path == neighbour.path; };
  const Reading& reading = step.reading;
  const bool varies = std::ranges::any_of(reading.varied, is_it) || std::ranges::any_of(reading.operands, is_it);
  const bool is_checked_anyway = varies && !std::isnan(neighbour.safe);  // at each point, whether it is safe
  const std::optional<KeptBound> bound = varies ? std::nullopt : kept_bound(evaluation, neighbour);
  if (bound) weighed.bounds.push_back(*bound);
  if (neighbour.of_bound && std::isnan(neighbour.value.si[0])) return;
  weighed.compared_by_size = weighed.compared_by_size || (neighbour.by_size && !bound && !is_checked_anyway);
  double& safe = weighed.compared.try_emplace(neighbour.path, neighbour.safe).first->second;
  if (!(safe <= neighbour.safe)) safe = std::isnan(safe) ? safe : neighbour.safe;
}

/// The neighbours less favourable than the typed value.
std::vector<Neighbour> bolder_ones(const Evaluation& evaluation, const Results& results, const Known& known,
                                   WeighedValues& weighed) {
  std::vector<Neighbour> bolder;
  std::vector<Neighbour> all = all_neighbours(evaluation, results, known);
  add_own_bounds(evaluation, known, all);
  for (Neighbour& neighbour : all) {
    note_compared(evaluation, neighbour, weighed);
    if (is_of_one_part(neighbour.kind)) continue;
    const double typed = typed_value(evaluation, neighbour), other = largest_magnitude(neighbour.value);
    const bool is_the_same =
        std::isnan(typed) || is_equal(neighbour.kind, typed, other, rounding_of(evaluation, neighbour));
    const bool lacks_margin = neighbour.margin > 0.0 && neighbour.margin * typed > other && typed < other;
    if ((is_the_same && neighbour.margin > 0.0 && !std::isnan(typed)) || lacks_margin) {
      neighbour.is_full = true;
      for (double& si : neighbour.value.si) si *= 0.5;  // a lower value shows which checks it decides
      bolder.push_back(std::move(neighbour));
      continue;
    }
    if (is_the_same && neighbour.kind != FieldRole::usual) continue;
    if (is_bolder(neighbour.kind, typed, other)) bolder.push_back(std::move(neighbour));
  }
  return bolder;
}

/// Whether a result is the same in other results; NaN equals NaN.
bool is_same_in(const Results& others, const ResultSeries& series) {
  const auto is_it = [&](const ResultSeries& other) { return other.path == series.path; };
  const auto other = std::find_if(others.series.begin(), others.series.end(), is_it);
  if (other == others.series.end()) return false;
  const std::vector<double>&a = series.value.si, &b = other->value.si;
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return x == y || (x != x && y != y); });
}

/// Evaluates with the neighbour in place of the typed value.
Results results_with(Evaluation& evaluation, const Neighbour& neighbour) {
  Inputs& inputs = evaluation.inputs();
  const Value typed = inputs.value_of(neighbour.path, neighbour.leaf);
  Value instead = neighbour.value;
  const bool may_be_series = inputs.find_computed(neighbour.path) != nullptr;
  if (instead.is_series() && (!may_be_series || instead.signature.axis != evaluation.axis()))
    instead = {{instead.signature.dimension, nullptr}, {largest_magnitude(instead)}};
  inputs.set_value(neighbour.path, neighbour.leaf, instead);
  Results results = evaluate_all(evaluation);
  inputs.set_value(neighbour.path, neighbour.leaf, typed);
  return results;
}

bool is_verdict(const FieldInfo& field) { return field.role == Role::check || field.role == Role::limit; }

bool is_kept(const ResultSeries& series) {
  return std::all_of(series.value.si.begin(), series.value.si.end(),
                     [&](double si) { return account::is_kept(*series.field, si); });
}

/// Whether a check or limit passes in one and not in the other.
bool passes_in_the_first_only(const ResultSeries& first, const Results& second) {
  const auto same = std::find_if(second.series.begin(), second.series.end(),
                                 [&](const ResultSeries& other) { return other.path == first.path; });
  return is_kept(first) && same != second.series.end() && !is_kept(*same);
}

/// Whether a check is lower in one than in the other.
bool is_lower_in_the_first(const ResultSeries& first, const Results& second) {
  const auto same = std::find_if(second.series.begin(), second.series.end(),
                                 [&](const ResultSeries& other) { return other.path == first.path; });
  return first.field->role == Role::check && same != second.series.end() &&
         largest_magnitude(first.value) < largest_magnitude(same->value);
}

/// Whether a value that no step has found is so far outside its usual range that its unit may be wrong: by a quarter.
bool is_far_from_usual(const Evaluation& evaluation, const Neighbour& neighbour) {
  constexpr double far = 1.25;
  const double typed = unusual_value(evaluation, neighbour);
  const Range& usual = neighbour.leaf.field->plausible;
  if (is_found(evaluation.step().input().reading, neighbour.path)) return false;
  return typed > far * usual.high || typed < usual.low / far;
}

/// Marks the checks and limits that change with the neighbour in place of the value; for the nearest usual value,
/// those that pass only with the typed one, and if it is `far` off those that it lowers. True if results change, but
/// no check or limit, or if a check exists only with the neighbour: sliding, with a speed other than zero.
bool mark_decided(const Results& with_typed, const Results& with_other, const LessConservative& bolder, FieldRole kind,
                  bool far, WeighedValues& weighed) {
  bool decides = false, changes = false, hides = false;
  for (const ResultSeries& series : with_typed.series) {
    if (is_same_in(with_other, series)) continue;
    changes = true;
    if (!is_verdict(*series.field)) continue;
    hides = hides || std::isnan(largest_magnitude(series.value));
    const bool by_value = kind == FieldRole::usual || kind == FieldRole::either;
    const bool is_decided = !by_value || passes_in_the_first_only(series, with_other) ||
                            ((far || kind == FieldRole::either) && is_lower_in_the_first(series, with_other));
    if (is_decided) weighed.decided.emplace(series.path, bolder);
    // A limit does not show on which side of it a value of another part is unsafe.
    decides = decides || is_decided || kind != FieldRole::either || series.field->role == Role::check;
  }
  return hides || (changes && !decides);
}

/// Whether a row of a table gives the value, which cannot be replaced.
bool is_of_row(const Evaluation& evaluation, const std::string& path) {
  const auto& provided = evaluation.inputs().provided();
  return std::any_of(provided.begin(), provided.end(),
                     [&](const Provided& one) { return one.path == path && !one.row.empty(); });
}

/// Whether other steps derive a conclusion from results of a step without checks: a fatigue limit.
bool is_concluded_elsewhere(const StepInput& step, const std::set<std::string>& taken) {
  const auto& fields = step.calculator->result->fields;
  const auto first = taken.lower_bound(step.name + ".");
  const auto is_check = [](const FieldInfo& field) { return field.role == Role::check; };
  return std::none_of(fields.begin(), fields.end(), is_check) && first != taken.end() &&
         first->starts_with(step.name + ".");
}

/// Whether a reason may be about a load that is less than its series (lib/project/references/reductions.hpp).
bool answers_for_reduction(const Reading& reading, const std::string& path) {
  const auto& operands = reading.operands;
  return std::any_of(operands.begin(), operands.end(), [&](const Operand& o) {
    return o.path == path && !o.of_record && !o.expression.references().empty();
  });
}

/// Reasons that no typed value needs.
void refuse_idle_reasons(const Step& of, const std::set<const Typed*>& used, std::vector<Issue>& issues) {
  const StepInput& step = of.input();
  for (const auto& [key, reason] : step.because) {
    const bool is_for_factor = of.loads().justified.contains(key);
    if (used.contains(&reason) || is_for_factor || answers_for_reduction(step.reading, key)) continue;
    const FieldInfo* const field = find_field(step.calculator->input->fields, key);
    const bool may_be_needed = field != nullptr && !facts_of(*field).empty() && !of.body_facts();
    if (may_be_needed) continue;                                             // another step may describe the same body
    if (field != nullptr && field->type == FieldInfo::Type::list) continue;  // a later step may contradict an element
    issues.push_back({reason.place, step.name + ".because." + key,
                      say("because.{1} is not needed: no row or record has a lower value of {1}", key),
                      say("omit it; to accept a failure mode use accept.MODE"), Severity::error});
  }
}

/// Results of another part than the one that a load comes from, without a reason for that load.
void weigh_results(const Evaluation& evaluation, const Results& results, const Known& known, WeighedValues& weighed) {
  for (const Differing& result : differing_results(evaluation, results, known)) {
    if (const Typed* const reason = reason_for(evaluation.step().input(), result.load))
      weighed.reasons.emplace(result.load, say("{1}: {2}", result.text, reason->text));
    else
      weighed.handed_on.push_back(
          {"because." + result.load, say("{1}; give the reason: because.{2} = \"...\"", result.text, result.load)});
  }
}

/// The reason for a size of a body that differs from that of the record of a load: another component takes the load.
const Typed* reason_for_body(const Evaluation& evaluation, const Neighbour& neighbour) {
  return neighbour.leaf.field->is_of_body ? reason_for(evaluation.step().input(), neighbour.path) : nullptr;
}

/// How to resolve a typed value that differs from that of a row or a record for the same part.
Message way_out(const Neighbour& neighbour) {
  const FieldInfo& field = *neighbour.leaf.field;
  if (!neighbour.row_of.empty())
    return say("leave out {1}; another part is a row of your own: [tables.{2}s.NAME]", field.key, neighbour.row_of);
  return field.is_of_body
             ? say("give {1} once, or the same value in both; for another component: because.{2} = \"...\"", field.key,
                   neighbour.path)
             : say("give {1} once, or the same value in both", field.key);
}

/// Sizes of another component than that of the record of the load, with their reasons.
void weigh_bodies(const Evaluation& evaluation, const Known& known, std::set<const Typed*>& used,
                  WeighedValues& weighed) {
  if (evaluation.step().input().because.empty()) return;
  for (const Neighbour& neighbour : all_neighbours(evaluation, {}, known)) {
    const Typed* const reason = is_of_one_part(neighbour.kind) ? reason_for_body(evaluation, neighbour) : nullptr;
    const double typed = typed_value(evaluation, neighbour), other = largest_magnitude(neighbour.value);
    if (reason == nullptr || std::isnan(typed) ||
        is_equal(neighbour.kind, typed, other, rounding_of(evaluation, neighbour)))
      continue;
    used.insert(reason);
    const FieldInfo& field = *neighbour.leaf.field;
    weighed.reasons.emplace(neighbour.path, say("{1} = {2}, and {3} has {4}: {5}", neighbour.path, shown(field, typed),
                                                neighbour.source, shown(field, other), reason->text));
  }
}

}  // namespace

bool refuse_other_parts(const Evaluation& evaluation, const Known& known, std::vector<Issue>& issues) {
  const std::size_t before = issues.size();
  const StepInput& step = evaluation.step().input();
  for (const Neighbour& neighbour : all_neighbours(evaluation, {}, known)) {
    if (!is_of_one_part(neighbour.kind) || reason_for_body(evaluation, neighbour) != nullptr) continue;
    const double typed = typed_value(evaluation, neighbour), other = largest_magnitude(neighbour.value);
    if (std::isnan(typed) || is_equal(neighbour.kind, typed, other, rounding_of(evaluation, neighbour))) continue;
    const FieldInfo& field = *neighbour.leaf.field;
    issues.push_back(issue_at(step, neighbour.path,
                              say("{1} = {2} contradicts {3}, which has {4}", neighbour.path, shown(field, typed),
                                  neighbour.source, shown(field, other)),
                              way_out(neighbour)));
  }
  return issues.size() == before;
}

WeighedValues weigh_typed_values(Evaluation& evaluation, const Results& results, const Known& known,
                                 const Wanted& wanted, std::vector<Issue>& issues) {
  WeighedValues weighed;
  const StepInput& step = evaluation.step().input();
  std::set<const Typed*> used;
  std::vector<Neighbour> all = bolder_ones(evaluation, results, known, weighed);
  const auto reason_of = [&](const Neighbour& neighbour) { return reason_for(step, neighbour.path); };
  // Values that hold back a mode are reported before the others.
  std::stable_partition(all.begin(), all.end(),
                        [&](const Neighbour& neighbour) { return reason_of(neighbour) == nullptr; });
  const bool has_results = !results.series.empty();
  // The calculation in words may round otherwise than the ones that it is compared with.
  const Results as_typed = all.empty() || !has_results ? Results{} : evaluate_all(evaluation);
  for (const Neighbour& neighbour : all) {
    const Typed* const reason = reason_of(neighbour);
    const Message excess = excess_of(evaluation, neighbour);
    if (reason != nullptr) {
      used.insert(reason);
      weighed.reasons.emplace(neighbour.path, say("{1}: {2}", excess, reason->text));
    }
    weighed.holds_back = weighed.holds_back || (reason == nullptr && has_results);
    if (!has_results || (reason != nullptr && !wanted.unused)) continue;
    const LessConservative bolder =
        reason != nullptr
            ? LessConservative{"", weighed.reasons.at(neighbour.path)}
            : LessConservative{"because." + neighbour.path,
                               say("{1}; give the reason: because.{2} = \"...\"", excess, neighbour.path)};
    const bool is_far = neighbour.kind == FieldRole::usual && is_far_from_usual(evaluation, neighbour);
    const bool only_changes =
        mark_decided(as_typed, results_with(evaluation, neighbour), bolder, neighbour.kind, is_far, weighed);
    const bool goes_on = neighbour.kind != FieldRole::usual || is_concluded_elsewhere(step, wanted.taken);
    const bool stays = is_of_row(evaluation, neighbour.path);
    if (((only_changes && goes_on) || stays) && reason == nullptr) weighed.handed_on.push_back(bolder);
  }
  if (!all.empty() && has_results) evaluate_all(evaluation);  // restored
  weigh_bodies(evaluation, known, used, weighed);
  weigh_results(evaluation, results, known, weighed);
  if (wanted.unused && has_results && step.reading.varied.empty()) refuse_idle_reasons(evaluation.step(), used, issues);
  return weighed;
}

}  // namespace loadpath::project
