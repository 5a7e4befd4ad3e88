// The search for a size or a row: the first, from small to large, with which the step passes; and of a load or a length
// the largest.
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
  std::vector<Issue> lacks;  // a row that lacks what is needed does not pass
  take_row(step_.searches().front().path, all.rows[i], lacks);
}

/// Whether the step passes with a candidate; `covered`: within the limits of all methods too.
bool Run::fits(const Candidates& all, std::size_t i, bool covered) {
  try_candidate(all, i);
  return passes() && (!covered || keeps_limits(false));
}

/// A stock ends where a value that is needed is missing: no larger one can pass. A table goes on with its next row.
std::size_t Run::first_that_fits(const Candidates& all, std::size_t from, bool covered) {
  for (std::size_t i = from; i < all.count(); ++i) {
    if (fits(all, i, covered) || (all.leaf && lacks_needed_)) return i;
  }
  return all.count();
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
  for (const FieldInfo& f : calculator_.result->fields) {
    if (f.role != Role::check || *f.asked_by == '\0') continue;
    if (std::find(asking.begin(), asking.end(), f.asked_by) == asking.end()) asking.emplace_back(f.asked_by);
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
    if (first_broken_rule() == calculator_.rules.size()) return true;
  }
  try_candidate(all, all.count() - 1);
  return false;
}

Message Run::fault_of_candidate() {
  if (!settle_sizes()) return missing_;
  if (const std::size_t rule = first_broken_rule(); rule < calculator_.rules.size())
    return step_.broken_rule(rule, record_, provided_).message;
  const FieldInfo* worst = nullptr;
  double most = 1.0;
  for (const FieldInfo& f : calculator_.result->fields) {
    if (f.role != Role::check || !is_asked(f) || f.is_beside) continue;
    const double largest = largest_result(f);
    if (std::isnan(largest) ? f.where_set : largest <= most) continue;
    worst = &f;
    most = std::isnan(largest) ? most : largest;
  }
  if (worst != nullptr) return say("{1} = {2}", worst->key, format_number(largest_result(*worst), 4));
  return say("a limit is not kept");
}

bool Run::search(std::vector<Issue>& issues) {
  if (step_.searches().empty()) return true;
  const Search& wanted = step_.searches().front();
  const std::size_t before = issues.size();
  if (wanted.leaf && wanted.stock.empty())
    search_most(wanted, issues);
  else
    search_first(wanted, issues);
  return issues.size() == before;
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
  tell_found(wanted, all, found);
}

/// What was found, and why the one before it is too small.
void Run::tell_found(const Search& wanted, const Candidates& all, std::size_t found) {
  const std::string stock = wanted.stock.empty() ? wanted.path : wanted.stock;
  const bool lacks = found < all.count() && lacks_needed_;
  Message text = say("smallest of {1} that passes every check", stock);
  if (lacks) text = say("first of {1} for which a value is missing", stock);
  if (found == all.count()) text = say("largest of {1}; none passes", stock);
  if (found > 0 && found < all.count() && !lacks) {
    try_candidate(all, found - 1);
    text = say("{1}; {2} fails: {3}", text, all.name(found - 1), fault_of_candidate());
    try_candidate(all, found);
    settle_sizes();
  }
  Origin origin = wanted.leaf ? stock_origin(*step_.input().tables, wanted.stock, std::move(text))
                              : Origin{std::move(text), {}, false};
  origin.searched = true;
  origins_[wanted.path] = std::move(origin);
}

}  // namespace loadpath::project
