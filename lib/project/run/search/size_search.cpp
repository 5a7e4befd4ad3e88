#include "lib/project/run/search/size_search.hpp"

#include "lib/account/rows.hpp"
#include "lib/project/run/search/remarks.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::project {

namespace {

/// Other words of the choice of a method, where the step has one: "; another method may cover it: johnson, ec3".
Message other_methods(const Evaluation& evaluation) {
  const FieldInfo* const method = find_field(evaluation.calculator().input->fields, "method");
  if (method == nullptr || method->type != FieldInfo::Type::choice) return {};
  const Leaf leaf = evaluation.inputs().leaf("method");
  std::string others;
  for (std::size_t i = 0; i < method->choices.size(); ++i) {
    if (static_cast<double>(i) != leaf.get() && *method->choices[i].key != '\0')
      others += (others.empty() ? "" : ", ") + std::string(method->choices[i].key);
  }
  return say("; another method may cover it: {1}", others);
}

constexpr double far_from_passing = 20.0;  // utilisation: a load in a wrong unit rather than a part that is too small

/// "T = 1056 kN*m": the first load that is given.
Message first_load(const Evaluation& evaluation) {
  for (const FieldInfo& field : evaluation.calculator().input->fields) {
    if (!field.is_load || field.type != FieldInfo::Type::quantity) continue;
    const double si = evaluation.inputs().leaf(field.key).get();
    if (std::isfinite(si) && si != 0.0) return say("{1} = {2}", field.key, format_quantity(si, field.unit, 4));
  }
  return {};
}

}  // namespace

SizeSearch::SizeSearch(Evaluation& evaluation, const Search& wanted, bool in_words, const JointRow* together)
    : evaluation_(evaluation),
      wanted_(wanted),
      in_words_(in_words),
      together_(together),
      candidates_(candidates_of(evaluation, wanted)),
      passing_(evaluation) {}

const BodySize* SizeSearch::size_of_body() const {
  const auto& sizes = evaluation_.step().body_sizes();
  const auto found = sizes.find(wanted_.path);
  return found == sizes.end() ? nullptr : &found->second;
}

bool SizeSearch::takes_size_of_body() {
  const BodySize* const body = size_of_body();
  if (body == nullptr || !body->is_given) return false;
  candidates_.leaf.set(body->si);
  Message text = say("of {1}, the same body '{2}'", body->by, evaluation_.step().input().body.text);
  evaluation_.inputs().set_origin(wanted_.path, {.text = std::move(text), .sources = {}, .searched = true});
  evaluation_.settle_sizes();
  return true;
}

void SizeSearch::run(std::vector<Issue>& issues) {
  if (takes_size_of_body()) return;
  evaluation_.settle_sizes();
  const auto& results = evaluation_.calculator().result->fields;
  const FieldInfo* const result = wanted_.leaf ? find_field(results, wanted_.path) : nullptr;
  const double least = result == nullptr ? std::nan("") : evaluation_.largest_result(*result);
  // Without a minimum size, the checks give the reason. A size that does not settle, or is beyond the sizes of a row,
  // excludes no candidate, because candidates have a size.
  const bool is_beyond_table = !evaluation_.inputs().table_gap().empty();
  if (result != nullptr && std::isnan(least) && evaluation_.is_settled() && !is_beyond_table) return;
  if (result == nullptr && !passing_.is_any_asked())
    return issues.push_back(aimless_search(evaluation_.step(), wanted_));
  keep_sizing_results();
  const bool has_no_pair = together_ != nullptr && together_->row.empty();
  if (together_ != nullptr && !has_no_pair) candidates_.rows = {together_->row};
  if (const BodySize* const body = size_of_body()) candidates_.keep_to_body(*body);
  const auto& sizes = candidates_.sizes;
  const auto start =
      std::isnan(least) ? sizes.begin() : std::lower_bound(sizes.begin(), sizes.end(), account::least_candidate(least));
  const auto from = static_cast<std::size_t>(start - sizes.begin());
  passing_.excuse_sizeless();
  std::size_t found = first_that_passes(from);
  if (has_no_pair && found == candidates_.count()) return report_none(from, issues);
  if (has_no_pair)
    return leave_open(say("{1}: none passes together with one of {2}", what_is_searched(), together_->with));
  const FailedValues unmoved = found == candidates_.count() ? unmoved_by_size(from) : FailedValues{};
  for (const auto& [row, value] : unmoved) passing_.excuse(row);
  const bool all_fail = std::ranges::any_of(unmoved, [](const auto& row) { return is_failure(*row.first.field); });
  if (!unmoved.empty()) found = first_that_passes(all_fail ? from : 0);
  if (found == candidates_.count()) return report_none(from, issues);
  if (all_fail) return report_nearest(found);
  if (in_words_) warn_of_passed_over(found, issues);
  candidates_.take(evaluation_.inputs(), found);
  evaluation_.settle_sizes();
  if (!in_words_) return note_found();
  warn_of_customs(evaluation_, issues);
  warn_of_found(evaluation_, wanted_, issues);
  report_found(found);
}

bool SizeSearch::keeps_rules_with(std::size_t i) {
  candidates_.take(evaluation_.inputs(), i);
  evaluation_.settle_sizes();
  return passing_.keeps_rules();
}

std::size_t SizeSearch::first_that_passes(std::size_t from) {
  for (std::size_t i = from; i < candidates_.count(); ++i) {
    candidates_.take(evaluation_.inputs(), i);
    if (passing_.passes()) return i;
  }
  return candidates_.count();
}

/// Checks and limits that no candidate satisfies: they fail with all, and do not improve from the first to the last.
FailedValues SizeSearch::unmoved_by_size(std::size_t from) {
  std::size_t first = from, last = candidates_.count();
  while (first < last && !keeps_rules_with(first)) ++first;
  if (first == last) return {};
  const FailedValues smallest = failed_values(evaluation_, passing_);
  do --last;
  while (last > first && !keeps_rules_with(last));
  if (last == first) return {};  // a single one shows no trend
  FailedValues unmoved = unmoved_values(smallest, failed_values(evaluation_, passing_));
  for (std::size_t i = first + 1; i < last && !unmoved.empty(); ++i) {
    if (!keeps_rules_with(i)) continue;
    const FailedValues here = failed_values(evaluation_, passing_);
    std::erase_if(unmoved, [&](const auto& failed) { return !here.contains(failed.first); });
  }
  return unmoved;
}

/// The candidate that is nearest to passing. None keeps the rules: past the last.
std::size_t SizeSearch::nearest(std::size_t from) {
  std::size_t best = candidates_.count();
  Shortfall least;
  for (std::size_t i = from; i < candidates_.count(); ++i) {
    if (!keeps_rules_with(i)) continue;
    const Shortfall here = shortfall_of_candidate(evaluation_, passing_);
    const bool is_nearer = candidates_.leaf ? here.is_less_than(least) : here.is_nearer_row_than(least);
    if (best != candidates_.count() && !is_nearer) continue;
    best = i;
    least = here;
  }
  return best;
}

/// Results of the sizing run for inputs left open, which are kept when the size is rounded up.
void SizeSearch::keep_sizing_results() {
  for (const FieldInfo& field : evaluation_.calculator().input->fields) {
    const Leaf leaf = evaluation_.inputs().leaf(field.key);
    const FieldInfo* const result = find_field(evaluation_.calculator().result->fields, field.key);
    if (!field.kept || result == nullptr || !std::isnan(leaf.get())) continue;
    const double si = evaluation_.largest_result(*result);
    if (std::isnan(si) || si == 0.0) continue;
    leaf.set(si);
    const Message text = say("of the least {1}, kept when it is rounded up", wanted_.path);
    evaluation_.inputs().set_origin(field.key, {text, {}, false});
  }
}

/// "d of R40", "section".
Message SizeSearch::what_is_searched() const {
  Message all = wanted_.stock.empty() ? say("{1}", wanted_.path) : say("{1} of {2}", wanted_.path, wanted_.stock);
  return wanted_.where.empty() ? all : say("{1} with {2}", std::move(all), wanted_.where);
}

/// A candidate that does not pass, and what it fails.
account::TriedSize SizeSearch::tried(std::size_t i) {
  candidates_.take(evaluation_.inputs(), i);
  const std::optional<double> si = candidates_.leaf ? std::optional(candidates_.sizes[i]) : std::nullopt;
  return tried_size(evaluation_.calculator(), candidates_.name(i).text(), si,
                    fault_of_candidate(evaluation_, passing_));
}

/// The nearest candidate, and those before and behind it.
std::vector<account::TriedSize> SizeSearch::tried_around(std::size_t best) {
  constexpr std::size_t before = 2, most = 4;
  std::vector<account::TriedSize> all;
  const std::size_t first = best - std::min(best, before);
  for (std::size_t i = first; i < std::min(first + most, candidates_.count()); ++i) all.push_back(tried(i));
  return all;
}

/// There is no result. Reports the nearest candidate, and its failures.
void SizeSearch::report_none(std::size_t from, std::vector<Issue>& issues) {
  if (candidates_.count() == 0)
    return leave_open(say("no value of {1} suits '{2}'", candidates_.source(), wanted_.path));
  std::size_t best = nearest(std::min(from, candidates_.count() - 1));
  if (best == candidates_.count()) best = nearest(0);
  if (best == candidates_.count()) return refuse_all(issues);
  std::vector<account::TriedSize> tried = tried_around(best);
  candidates_.take(evaluation_.inputs(), best);
  evaluation_.settle_sizes();
  const double check = shortfall_of_candidate(evaluation_, passing_).check;
  const bool uncovered = !(check > 1.0);
  Message fault = say("{1}: none passes, nearest is {2}: {3}", what_is_searched(), candidates_.name(best),
                      fault_in_full(evaluation_, fault_of_candidate(evaluation_, passing_)));
  if (const Message load = check > far_from_passing ? first_load(evaluation_) : Message{}; !load.empty())
    fault = say("{1}, with {2}: check this load", std::move(fault), load);
  if (uncovered) fault = say("{1}: the method is not valid there{2}", fault, other_methods(evaluation_));
  leave_open(std::move(fault), std::move(tried));
}

/// All fail the same check or requirement, as roller bearings without ribs under an axial load. Reports the first that
/// passes in all else.
void SizeSearch::report_nearest(std::size_t nearest) {
  candidates_.take(evaluation_.inputs(), nearest);
  evaluation_.settle_sizes();
  Passing whole(evaluation_);
  whole.excuse_sizeless();
  const CandidateFault fault = fault_of_candidate(evaluation_, whole);
  const Message name = candidates_.name(nearest);
  Message why = say("{1}: none passes, nearest is {2}: {3}; all others fail this too", what_is_searched(), name,
                    fault_in_full(evaluation_, fault));
  const std::optional<double> si = candidates_.leaf ? std::optional(candidates_.sizes[nearest]) : std::nullopt;
  leave_open(std::move(why), {tried_size(evaluation_.calculator(), name.text(), si, fault)});
}

/// No candidate keeps the rules, or has a size that settles.
void SizeSearch::refuse_all(std::vector<Issue>& issues) {
  const std::size_t last = candidates_.count() - 1;
  keeps_rules_with(last);
  const auto rule = passing_.first_broken_rule();
  if (!rule) {
    return leave_open(say("{1}: none passes, nearest is {2}: {3}", what_is_searched(), candidates_.name(last),
                          fault_of_candidate(evaluation_, passing_).text));
  }
  Issue issue = evaluation_.broken_rule(*rule);
  issue.hint =
      say("{1} = {2}, the largest of {3}, was tried last", wanted_.path, candidates_.name(last), candidates_.source());
  issues.push_back(std::move(issue));
}

void SizeSearch::leave_open(Message why, std::vector<account::TriedSize> tried) {
  candidates_.leave_open(evaluation_.inputs(), why, std::move(tried));
  evaluation_.inputs().set_unavailable(std::move(why), account::Subject::search);
}

/// Rows before the result for which the step cannot be calculated: they are not failures, and the user may prefer
/// them.
void SizeSearch::warn_of_passed_over(std::size_t found, std::vector<Issue>& issues) {
  std::size_t count = 0;
  Issue first;
  for (std::size_t i = 0; i < found && !candidates_.leaf && !candidates_.chosen; ++i) {
    keeps_rules_with(i);
    const auto rule = passing_.first_broken_rule();
    if (!rule || count++ > 0) continue;
    const Issue fault = evaluation_.broken_rule(*rule);
    first = issue_at(evaluation_.step().input(), wanted_.path, say("{1}: {2}", candidates_.name(i), fault.message),
                     fault.hint);
  }
  if (count == 0) return;
  first.message =
      say("of the rows that were tried {1} are passed over, the first is {2}", std::to_string(count), first.message);
  first.place = wanted_.place;
  first.severity = Severity::warning;
  issues.push_back(std::move(first));
}

/// Records the size without text: a body only needs the sizes found.
void SizeSearch::note_found() {
  if (wanted_.leaf)
    evaluation_.inputs().set_origin(wanted_.path, {.text = say("found"), .sources = {}, .searched = true});
}

/// "smallest of R40 with which no assessed mode fails"
Message SizeSearch::how_found(bool covered) const {
  const Message source = wanted_.where.empty() ? say("{1}", candidates_.source())
                                               : say("{1} with {2}", candidates_.source(), wanted_.where);
  if (together_ != nullptr)
    return say("of {1}, the smallest pair with {2} with which no assessed mode of either fails", source,
               together_->with);
  return covered ? say("smallest of {1} with which no assessed mode fails", source)
                 : say("smallest of {1} with which no assessed mode that depends on it fails", source);
}

/// Reports the result, and the reason why the previous candidate is too small.
void SizeSearch::report_found(std::size_t found) {
  Passing whole(evaluation_);  // includes the excused ones
  const bool covered = passing_.count_of_excused() == 0 || whole.passes();
  Message text = how_found(covered);
  if (const BodySize* const body = size_of_body())
    text = say("{1}; the body '{2}' has this size: {3}", text, evaluation_.step().input().body.text, body->by);
  std::optional<account::TriedSize> next;
  if (found > 0) {
    next = tried(found - 1);
    text = say("{1}; {2} fails: {3}", text, candidates_.name(found - 1), next->reason);
    candidates_.take(evaluation_.inputs(), found);
    evaluation_.settle_sizes();
  }
  if (!covered) text = say("{1}; not met at any size: {2}", text, fault_of_candidate(evaluation_, whole).text);
  Origin origin = wanted_.leaf ? stock_origin(*evaluation_.step().input().tables, wanted_.stock, std::move(text))
                               : Origin{std::move(text), {}, false};
  origin.searched = true;
  origin.next = std::move(next);
  evaluation_.inputs().set_origin(wanted_.path, std::move(origin));
}

}  // namespace loadpath::project
