// The search for a size or a row: the first, from small to large, with which the step passes; and of a load or a length
// the largest.
#include "lib/numerics/magnitude.hpp"
#include "lib/project/run/run.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace loadpath::project {

Message Run::Candidates::name(std::size_t i) const {
  return leaf ? say("{1}", format_quantity(sizes[i], leaf.field->unit)) : say("{1}", rows[i]);
}

Run::Candidates Run::candidates_of(const Search& wanted) const {
  Candidates all{map_leaf(wanted.path), {}, {}};
  if (all.leaf) {
    all.sizes = stock_values(*step_.input().tables, wanted.stock);
    const FieldInfo& field = *all.leaf.field;  // typed, an unusual size would be warned of: none is found
    std::erase_if(all.sizes, [&](double size) { return !field.bounds.holds(size) || !field.plausible.holds(size); });
  } else {
    for (const table::Entry& row : step_.input().tables->ordered_rows(wanted.path, wanted.stock))
      all.rows.push_back(row.row->name);
  }
  return all;
}

/// What another step of the same body gives is not searched for: this one is assessed at it. Whether that is so.
bool Run::takes_size_of_body(const Search& wanted) {
  const auto body = step_.body_sizes().find(wanted.path);
  if (body == step_.body_sizes().end() || !body->second.is_given) return false;
  map_leaf(wanted.path).set(body->second.si);
  origins_[wanted.path] = {say("of {1}, the same body '{2}'", body->second.by, step_.input().body.text), {}, false};
  origins_[wanted.path].searched = true;
  settle_sizes();
  return true;
}

/// No size is smaller than what the other steps of the same body ask for.
void Run::keep_to_body(const std::string& path, Candidates& all) const {
  const auto body = step_.body_sizes().find(path);
  if (body == step_.body_sizes().end()) return;
  std::erase_if(all.sizes, [&](double size) { return size < body->second.si * (1.0 - 1e-12); });
}

void Run::try_candidate(const Candidates& all, std::size_t i) {
  if (all.leaf) return all.leaf.set(all.sizes[i]);
  std::vector<Issue> lacks;
  take_row(step_.searches().front().path, all.rows[i], lacks);
}

/// Whether no check, criterion or limit of a method fails with a candidate, but for the limits that are excused.
bool Run::fits(const Candidates& all, std::size_t i) {
  try_candidate(all, i);
  return passes() && keeps_limits(false);
}

std::size_t Run::first_that_fits(const Candidates& all, std::size_t from) {
  for (std::size_t i = from; i < all.count(); ++i) {
    if (fits(all, i)) return i;
  }
  return all.count();
}

/// Excuses what no candidate improves: limits that the first and the last that keep the rules fail with the same value,
/// and checks that are no better with the last. They decide the verdict of the step, whatever is found. Whether there
/// are any.
bool Run::excuse_unmoved(const Candidates& all, std::size_t from) {
  const auto values = [&] {
    std::map<const FieldInfo*, double> outside;
    for (const FieldInfo& f : calculator_.result->fields) {
      const bool judges = f.role == Role::limit || f.role == Role::check;
      if (!judges || !is_asked(f) || f.is_beside || excused_.contains(&f)) continue;
      const auto bad = f.role == Role::limit ? first_outside(f) : failed(f);
      if (bad && !std::isnan(*bad)) outside[&f] = *bad;
    }
    return outside;
  };
  const auto tried = [&](std::size_t i) {
    try_candidate(all, i);
    settle_sizes();
    return first_broken_rule() == calculator_.rules.size();
  };
  std::size_t first = from, last = all.count();
  while (first < last && !tried(first)) ++first;
  if (first == last) return false;
  const auto smallest = values();
  do --last;
  while (last > first && !tried(last));
  if (last == first) return false;  // a single one tells nothing
  const std::size_t before = excused_.size();
  for (const auto& [field, value] : values()) {
    const auto same = smallest.find(field);
    if (same == smallest.end()) continue;
    const double change = value - same->second, rounding = 1e-9 * std::abs(value);
    const bool unmoved = field->role == Role::check ? change >= -rounding : std::abs(change) <= rounding;
    if (unmoved) excused_.insert(field);
  }
  return excused_.size() > before;
}

/// The largest value of a check that is not passed; nothing where it is.
std::optional<double> Run::failed(const FieldInfo& check) {
  const double largest = largest_result(check);
  return numerics::exceeds(largest, 1.0) ? std::optional(largest) : std::nullopt;
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

/// How far beyond its bounds a value is, as a factor; 1 within them.
double Run::excess_of(const FieldInfo& limit, double si) {
  const Range& bounds = limit.bounds;
  if (std::isnan(si)) return std::numeric_limits<double>::infinity();
  if (bounds.holds(si)) return 1.0;
  const double large = std::abs(si > bounds.high ? si : bounds.low);
  const double small = std::abs(si > bounds.high ? bounds.high : si);
  return small > 0.0 ? std::max(1.0, large / small) : std::numeric_limits<double>::infinity();
}

/// Adds what elements of a list lack, as they were evaluated last.
void Run::add_lack_of(const FieldInfo& list, Lack& lack) {
  for (std::size_t k = 0; k < list.size(result_.data.get()); ++k) {
    for (const FieldInfo& f : list.fields) {
      if (!is_held_against(f, true) && !is_held_against(f, false)) continue;
      const double si = f.get(list.element(result_.data.get(), k));
      if (std::isnan(si)) continue;  // what has no value is told by the limits
      if (f.role == Role::check) lack.check = std::max(lack.check, si);
      if (f.role == Role::limit) {
        double& most = f.is_criterion ? lack.check : lack.limit;
        most = std::max(most, excess_of(f, si));
      }
    }
  }
}

/// What a candidate lacks. A check without a value counts where no limit says why.
Run::Lack Run::lack_of_candidate() {
  Lack lack;
  bool missing = false;
  for (const FieldInfo& f : calculator_.result->fields) {
    if (f.type == FieldInfo::Type::list) {
      for (std::size_t i = 0; i < positions(); ++i) {
        if (!set_position(i)) continue;
        calculator_.evaluate(record_.data.get(), result_.data.get());
        add_lack_of(f, lack);
      }
    }
    if (!is_asked(f) || f.is_beside || excused_.contains(&f)) continue;
    if (f.role == Role::check) {
      const double largest = largest_result(f);
      missing = missing || (std::isnan(largest) && !f.where_set);
      if (numerics::exceeds(largest, lack.check)) lack.check = largest;
    } else if (f.role == Role::limit) {
      const auto bad = first_outside(f);
      if (!bad) continue;
      lack.limit = std::max(lack.limit, excess_of(f, *bad));
      if (f.is_criterion) lack.check = std::max(lack.check, lack.limit);
    }
  }
  if (missing && lack.limit <= 1.0) lack.check = std::numeric_limits<double>::infinity();
  return lack;
}

/// The candidate that lacks least: of those that fail nothing the one least beyond the methods, else the least
/// utilised. None keeps the rules: past the last.
std::size_t Run::nearest(const Candidates& all, std::size_t from) {
  std::size_t best = all.count();
  Lack least;
  for (std::size_t i = from; i < all.count(); ++i) {
    try_candidate(all, i);
    settle_sizes();
    if (first_broken_rule() < calculator_.rules.size()) continue;
    const Lack lack = lack_of_candidate();
    const bool better =
        best == all.count() || lack.check < least.check || (lack.check == least.check && lack.limit < least.limit);
    if (!better) continue;
    best = i;
    least = lack;
  }
  return best;
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

/// Without words: a body asks which sizes were found.
void Run::note_found(const Search& wanted) {
  if (!wanted.leaf) return;
  Origin& origin = origins_[wanted.path];
  origin.text = say("found");
  origin.searched = true;
}

void Run::search_first(const Search& wanted, std::vector<Issue>& issues) {
  if (takes_size_of_body(wanted)) return;
  settle_sizes();
  const FieldInfo* result = wanted.leaf ? find_field(calculator_.result->fields, wanted.path) : nullptr;
  const double least = result == nullptr ? std::nan("") : largest_result(*result);
  if (result != nullptr && std::isnan(least)) return;  // not even a least size: the checks say why
  if (result == nullptr && !is_any_asked()) return issues.push_back(aimless(wanted));
  keep_sizing_results(wanted.path);
  Candidates all = candidates_of(wanted);
  keep_to_body(wanted.path, all);
  const auto start = std::isnan(least) ? all.sizes.begin()
                                       : std::lower_bound(all.sizes.begin(), all.sizes.end(), least * (1.0 - 1e-12));
  const auto from = static_cast<std::size_t>(start - all.sizes.begin());
  for (const FieldInfo& f : calculator_.result->fields) {  // of the loads alone
    if (f.is_sizeless) excused_.insert(&f);
  }
  std::size_t found = first_that_fits(all, from);
  if (found == all.count() && excuse_unmoved(all, std::min(from, found))) found = first_that_fits(all, from);
  if (found == all.count()) return leave_without(wanted, all, from, issues);
  if (in_words_) warn_of_passed_over(wanted, all, found, issues);
  try_candidate(all, found);
  settle_sizes();
  if (!in_words_) return note_found(wanted);
  warn_of_found(wanted, issues);
  tell_found(wanted, all, found);
}

}  // namespace loadpath::project
