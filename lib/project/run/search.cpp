// The search for a size or a row: the first, from small to large, with which the step passes; and of a load or a length
// the largest.
#include "lib/numerics/magnitude.hpp"
#include "lib/project/run/run.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

Message Run::Candidates::name(std::size_t i) const {
  return leaf ? say("{1}", format_quantity(sizes[i], leaf.field->unit)) : say("{1}", rows[i]);
}

Run::Candidates Run::candidates_of(const Search& wanted) const {
  Candidates all{map_leaf(wanted.path), {}, {}};
  if (all.leaf) {
    all.sizes = stock_values(*step_.input().tables, wanted.stock);
    std::erase_if(all.sizes, [&](double size) { return !all.leaf.field->bounds.holds(size); });
  } else {
    for (const table::Entry& row : step_.input().tables->ordered_rows(wanted.path, wanted.stock))
      all.rows.push_back(row.row->name);
  }
  return all;
}

void Run::try_candidate(const Candidates& all, std::size_t i) {
  if (all.leaf) return all.leaf.set(all.sizes[i]);
  std::vector<Issue> lacks;
  take_row(step_.searches().front().path, all.rows[i], lacks);
}

/// Whether the step passes with a candidate; `covered`: within the limits of all methods too.
bool Run::fits(const Candidates& all, std::size_t i, bool covered) {
  try_candidate(all, i);
  return passes() && (!covered || keeps_limits(false));
}

std::size_t Run::first_that_fits(const Candidates& all, std::size_t from, bool covered) {
  for (std::size_t i = from; i < all.count(); ++i) {
    if (fits(all, i, covered)) return i;
  }
  return all.count();
}

/// Rows before the one that was found for which the step cannot be calculated: they are no failures, and may be what
/// the user would rather have.
void Run::warn_of_passed_over(const Search& wanted, const Candidates& all, std::size_t found,
                              std::vector<Issue>& issues) {
  std::size_t count = 0;
  Issue first;
  for (std::size_t i = 0; i < found && !all.leaf; ++i) {
    try_candidate(all, i);
    settle_sizes();
    const std::size_t rule = first_broken_rule();
    if (rule == calculator_.rules.size()) continue;
    if (count++ > 0) continue;
    const Issue fault = step_.broken_rule(rule, record_, provided_);
    first = issue_at(step_.input(), wanted.path, say("{1}: {2}", all.name(i), fault.message), fault.hint);
  }
  if (count == 0) return;
  first.message =
      say("of the rows that were tried {1} are passed over, the first is {2}", std::to_string(count), first.message);
  first.place = wanted.place;
  first.severity = Severity::warning;
  issues.push_back(std::move(first));
}

/// What the sizing run has found for inputs that were left open and stay as they are when the size is rounded up.
void Run::keep_sizing_results(const std::string& searched) {
  for (const FieldInfo& field : calculator_.input->fields) {
    const Leaf leaf = map_leaf(field.key);
    const FieldInfo* result = find_field(calculator_.result->fields, field.key);
    if (!field.kept || result == nullptr || !std::isnan(leaf.get())) continue;
    const double si = largest_result(*result);
    if (std::isnan(si) || si == 0.0) continue;
    leaf.set(si);
    origins_[field.key] = {say("of the least {1}, kept when it is rounded up", searched), {}, false};
  }
}

bool Run::is_any_asked() const {
  const auto& fields = calculator_.result->fields;
  return std::any_of(fields.begin(), fields.end(),
                     [&](const FieldInfo& f) { return f.role == Role::check && !f.is_beside && is_asked(f); });
}

/// A search without a check; its hint names what asks for one.
Issue Run::aimless(const Search& wanted) const {
  std::vector<std::string> asking;
  const auto ask = [&](const FieldInfo& f) {
    if (f.role != Role::check || *f.asked_by == '\0') return;
    if (std::find(asking.begin(), asking.end(), f.asked_by) == asking.end()) asking.emplace_back(f.asked_by);
  };
  for (const FieldInfo& f : calculator_.result->fields) {
    ask(f);
    std::for_each(f.fields.begin(), f.fields.end(), ask);
  }
  std::string names;
  for (const std::string& inputs : asking) names += ", " + inputs;
  return issue_at(
      step_.input(), wanted.path, say("nothing tells how large '{1}' must be: no check is asked for", wanted.path),
      say("give {1} itself, or what a check needs: {2}", wanted.path, names.empty() ? "" : names.substr(2)));
}

/// Sets the largest of the candidates with which every rule about it holds; false where none is, with the last one set.
bool Run::take_largest(const Candidates& all) {
  for (std::size_t i = all.count(); i-- > 0;) {
    try_candidate(all, i);
    settle_sizes();
    if (first_broken_rule() == calculator_.rules.size()) return true;
  }
  try_candidate(all, all.count() - 1);
  settle_sizes();
  return false;
}

/// The first limit that is not kept, of the criteria before those of the methods.
Message Run::fault_of_limits() {
  for (const bool criteria : {true, false}) {
    for (const FieldInfo& f : calculator_.result->fields) {
      if (f.role != Role::limit || !is_asked(f) || f.is_beside || f.is_criterion != criteria) continue;
      if (const auto bad = first_outside(f))
        return std::isnan(*bad) ? say("{1} is not available", f.key)
                                : say("{1} = {2}: {3}", f.key, format_quantity(*bad, f.unit, 4), bounds_message(f));
    }
  }
  return say("a check has no value");
}

/// The check in a list that is beyond 1 most, and beyond `most`; empty where none is.
Message Run::fault_of_lists(double most) {
  Message worst;
  for (std::size_t i = 0; i < positions(); ++i) {
    if (!set_position(i)) continue;
    calculator_.evaluate(record_.data.get(), result_.data.get());
    for_each_leaf(result_, [&](const std::string& path, const Leaf& leaf) {
      const bool listed = path.find('.') != std::string::npos;
      if (!listed || leaf.field->role != Role::check || !is_held_against(*leaf.field, true)) return;
      if (!numerics::exceeds(leaf.get(), most)) return;
      most = leaf.get();
      worst = say("{1} = {2}", path, format_number(most, 4));
    });
  }
  return worst;
}

Message Run::fault_of_candidate() {
  settle_sizes();
  const auto evaluated = [&](const FieldInfo& f) {  // of a part without positions from one evaluation
    return axis_ == nullptr ? f.get(result_.data.get()) : largest_result(f);
  };
  if (const std::size_t rule = first_broken_rule(); rule < calculator_.rules.size())
    return step_.broken_rule(rule, record_, provided_).message;
  if (axis_ == nullptr && set_position(0)) calculator_.evaluate(record_.data.get(), result_.data.get());
  const FieldInfo* worst = nullptr;  // a check without a value may be so for a limit that is not kept
  double most = 1.0;
  for (const FieldInfo& f : calculator_.result->fields) {
    if (f.role != Role::check || !is_asked(f) || f.is_beside) continue;
    const double largest = evaluated(f);
    if (!numerics::exceeds(largest, most)) continue;
    worst = &f;
    most = largest;
  }
  if (const Message listed = fault_of_lists(most); !listed.empty()) return listed;
  if (worst != nullptr) return say("{1} = {2}", worst->key, format_number(most, 4));
  return fault_of_limits();
}

bool Run::search(std::vector<Issue>& issues) {
  if (step_.searches().empty()) return true;
  const Search& wanted = step_.searches().front();
  if (step_.sizes_together())
    search_together(issues);
  else if (wanted.leaf && wanted.stock.empty())
    search_most(wanted, issues);
  else
    search_first(wanted, issues);
  return !has_errors(issues);
}

void Run::search_first(const Search& wanted, std::vector<Issue>& issues) {
  settle_sizes();
  const FieldInfo* result = wanted.leaf ? find_field(calculator_.result->fields, wanted.path) : nullptr;
  const double least = result == nullptr ? std::nan("") : largest_result(*result);
  if (result != nullptr && std::isnan(least)) return;  // not even a least size: the checks say why
  if (result == nullptr && !is_any_asked()) return issues.push_back(aimless(wanted));
  keep_sizing_results(wanted.path);
  const Candidates all = candidates_of(wanted);
  const auto start = std::isnan(least) ? all.sizes.begin()
                                       : std::lower_bound(all.sizes.begin(), all.sizes.end(), least * (1.0 - 1e-12));
  const auto from = static_cast<std::size_t>(start - all.sizes.begin());
  std::size_t found = first_that_fits(all, from, true);
  if (found == all.count()) found = first_that_fits(all, from, false);
  if (found == all.count() && all.count() > 0 && !take_largest(all)) {
    Issue issue = step_.broken_rule(first_broken_rule(), record_, provided_);
    issue.hint = say("{1} = {2}, the largest of {3}, was tried last", wanted.path, all.name(all.count() - 1),
                     wanted.stock.empty() ? wanted.path : wanted.stock);
    return issues.push_back(std::move(issue));
  }
  if (found < all.count()) {
    if (in_words_) warn_of_passed_over(wanted, all, found, issues);
    try_candidate(all, found);
    settle_sizes();
  }
  if (in_words_) tell_found(wanted, all, found);
}

/// What was found, and why the one before it is too small.
void Run::tell_found(const Search& wanted, const Candidates& all, std::size_t found) {
  const std::string stock = wanted.stock.empty() ? wanted.path : wanted.stock;
  Message text = say("smallest of {1} that passes every check", stock);
  if (found == all.count()) text = say("largest of {1}; none passes", stock);
  if (found > 0 && found < all.count()) {
    try_candidate(all, found - 1);
    text = say("{1}; {2} fails: {3}", text, all.name(found - 1), fault_of_candidate());
    try_candidate(all, found);
    settle_sizes();
  }
  if (found < all.count() && !keeps_limits(false))
    text = say("{1}; beyond the range of its formulas: {2}", text, fault_of_limits());
  Origin origin = wanted.leaf ? stock_origin(*step_.input().tables, wanted.stock, std::move(text))
                              : Origin{std::move(text), {}, false};
  origin.searched = true;
  origins_[wanted.path] = std::move(origin);
}

}  // namespace loadpath::project
