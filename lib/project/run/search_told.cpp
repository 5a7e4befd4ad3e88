// What a search tells: what was found and why the one before it is too small, or why nothing is found and what the
// nearest candidate fails.
#include "lib/numerics/magnitude.hpp"
#include "lib/project/run/run.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::project {

/// What fails with every candidate.
Message Run::fault_of_excused() {
  const auto excused = std::exchange(excused_, {});
  Message fault = fault_of_candidate();
  excused_ = excused;
  return fault;
}

/// The first limit that is not kept, of the criteria before those of the methods.
Message Run::fault_of_limits() {
  for (const bool criteria : {true, false}) {
    for (const FieldInfo& f : calculator_.result->fields) {
      if (f.role != Role::limit || !is_asked(f) || f.is_beside || f.is_criterion != criteria) continue;
      if (excused_.contains(&f)) continue;
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
    if (f.role != Role::check || !is_asked(f) || f.is_beside || excused_.contains(&f)) continue;
    const double largest = evaluated(f);
    if (!numerics::exceeds(largest, most)) continue;
    worst = &f;
    most = largest;
  }
  if (const Message listed = fault_of_lists(most); !listed.empty()) return listed;
  if (worst != nullptr) return say("{1} = {2}", worst->key, format_number(most, 4));
  return fault_of_limits();
}

/// Other words of the choice of a method, where the step has one: "; another method may cover it: johnson, ec3".
Message Run::other_methods() const {
  const FieldInfo* const method = find_field(calculator_.input->fields, "method");
  if (method == nullptr || method->type != FieldInfo::Type::choice) return {};
  const Leaf leaf = find_leaf(record_, "method");
  std::string others;
  for (std::size_t i = 0; i < method->choices.size(); ++i) {
    if (static_cast<double>(i) != leaf.get())
      others += (others.empty() ? "" : ", ") + std::string(method->choices[i].key);
  }
  return say("; another method may cover it: {1}", others);
}

/// Customs that what was found breaks, in the words in which a typed value would be warned of.
void Run::warn_of_found(const Search& wanted, std::vector<Issue>& issues) {
  for (std::size_t rule = 0; rule < calculator_.rules.size(); ++rule) {
    if (!calculator_.rules[rule].only_warns || !waits_for_search(rule)) continue;
    bool holds = true;
    for (std::size_t i = 0; i < positions() && holds; ++i)
      holds = !set_position(i) || calculator_.holds(rule, record_.data.get());
    if (!holds) issues.push_back(step_.broken_rule(rule, record_, provided_));
  }
  if (!wanted.leaf || wanted.leaf.field->plausible.holds(map_leaf(wanted.path).get())) return;
  Issue issue =
      issue_at(step_.input(), wanted.path, unusual(wanted.path, *wanted.leaf.field, map_leaf(wanted.path).get()));
  issue.place = wanted.place;
  issue.severity = Severity::warning;
  issues.push_back(std::move(issue));
}

/// No candidate passes: there is no result. Told is the nearest one, and what it fails by.
void Run::leave_without(const Search& wanted, const Candidates& all, std::size_t from, std::vector<Issue>& issues) {
  const std::string stock = wanted.stock.empty() ? wanted.path : wanted.stock;
  if (all.count() == 0) return leave_open(wanted, say("{1} has no value that '{2}' may have", stock, wanted.path));
  const std::size_t best = nearest(all, std::min(from, all.count() - 1));
  if (best == all.count()) {
    try_candidate(all, all.count() - 1);
    settle_sizes();
    Issue issue = step_.broken_rule(first_broken_rule(), record_, provided_);
    issue.hint = say("{1} = {2}, the largest of {3}, was tried last", wanted.path, all.name(all.count() - 1), stock);
    return issues.push_back(std::move(issue));
  }
  try_candidate(all, best);
  settle_sizes();
  const bool uncovered = !(lack_of_candidate().check > 1.0);
  Message fault =
      say("{1} of {2}: none passes, nearest is {3}: {4}", wanted.path, stock, all.name(best), fault_of_candidate());
  if (uncovered) fault = say("{1}: the method is not valid there{2}", fault, other_methods());
  leave_open(wanted, std::move(fault));
}

/// The input that was searched for, and what a row would have given, have no value.
void Run::leave_open(const Search& wanted, Message why) {
  not_given_ = std::move(why);
  search_failed_ = true;
  Origin origin{not_given_, {}, false};
  origin.searched = true;
  if (wanted.leaf) {
    map_leaf(wanted.path).set(std::nan(""));
  } else {
    const auto of_row = [&](const Provided& p) { return !p.row.empty() && p.field->provider.table == wanted.path; };
    const Record untouched(*calculator_.input);
    for (const Provided& provided : provided_) {
      if (!of_row(provided)) continue;
      const Leaf leaf = map_leaf(provided.path);
      const bool is_quantity = leaf.field->type == FieldInfo::Type::quantity;
      const double si = is_quantity ? std::nan("") : find_leaf(untouched, provided.path).get();
      if (is_quantity || !std::isnan(si)) leaf.set(si);  // a choice has no value that is none
    }
    std::erase_if(provided_, of_row);
    rows_[wanted.path].text.clear();
  }
  origins_[wanted.path] = std::move(origin);
}

/// What was found, and why the one before it is too small.
void Run::tell_found(const Search& wanted, const Candidates& all, std::size_t found) {
  const std::string stock = wanted.stock.empty() ? wanted.path : wanted.stock;
  const bool covered = excused_.empty() || passes_whole();
  Message text = covered ? say("smallest of {1} that passes every check", stock)
                         : say("smallest of {1} that passes every check that depends on it", stock);
  const auto body = step_.body_sizes().find(wanted.path);
  if (body != step_.body_sizes().end())
    text = say("{1}; the body '{2}' has this size: {3}", text, step_.input().body.text, body->second.by);
  if (found > 0) {
    try_candidate(all, found - 1);
    text = say("{1}; {2} fails: {3}", text, all.name(found - 1), fault_of_candidate());
    try_candidate(all, found);
    settle_sizes();
  }
  if (!covered) text = say("{1}; not met at any size: {2}", text, fault_of_excused());
  Origin origin = wanted.leaf ? stock_origin(*step_.input().tables, wanted.stock, std::move(text))
                              : Origin{std::move(text), {}, false};
  origin.searched = true;
  origins_[wanted.path] = std::move(origin);
}

}  // namespace loadpath::project
