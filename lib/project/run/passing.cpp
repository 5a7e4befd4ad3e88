// Whether a step passes as it is now: what a search asks of every candidate.
#include "lib/project/run/run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::project {

bool Run::is_asked(const FieldInfo& check) const { return step_.is_asked(check, record_); }

/// Whether a rule is about the input that is searched for, or about those that the row gives which is. Of a load it may
/// be any: what a part needs is asked where it is loaded.
bool Run::concerns_search(std::size_t rule) const {
  const Search& wanted = step_.searches().front();
  if (wanted.leaf && wanted.leaf.field->is_load) return true;
  if (wanted.leaf) return step_.is_about(rule, wanted.path);
  const auto fields = listed_keys(calculator_.rules[rule].fields);
  return std::any_of(fields.begin(), fields.end(), [&](const std::string& key) {
    const FieldInfo* const field = find_field(calculator_.input->fields, key);
    return field != nullptr && field->provider.table == wanted.path;
  });
}

bool Run::waits_for_search(std::size_t rule) const {
  if (step_.searches().empty()) return false;
  const Search& wanted = step_.searches().front();
  return !(wanted.leaf && wanted.leaf.field->sought_unasked) && concerns_search(rule);
}

/// The first rule about the input that is searched for that is broken at a position; none: past the last.
std::size_t Run::first_broken_rule() {
  const std::size_t count = calculator_.rules.size();
  for (std::size_t rule = concerned_.size(); rule < count; ++rule)  // once, not for every candidate
    concerned_.push_back(!calculator_.rules[rule].only_warns && concerns_search(rule));
  for (std::size_t i = 0; i < positions(); ++i) {
    if (!set_position(i)) continue;
    for (std::size_t rule = 0; rule < count; ++rule) {
      if (!concerned_[rule]) continue;
      if (!calculator_.holds(rule, record_.data.get())) return rule;
    }
  }
  return count;
}

bool Run::passes() {
  settle_sizes();
  if (first_broken_rule() < calculator_.rules.size()) return false;
  const auto& fields = calculator_.result->fields;
  return std::all_of(fields.begin(), fields.end(),
                     [&](const FieldInfo& f) {
                       if (f.role != Role::check || !is_asked(f) || f.is_beside || excused_.contains(&f)) return true;
                       return account::is_kept(f, largest_result(f));
                     }) &&
         keeps_limits(true);
}

/// Whether a field of a list's element is a check or a criterion, or the limit of a method.
bool Run::is_held_against(const FieldInfo& f, bool criteria) const {
  const bool judges = f.role == Role::limit ? f.is_criterion == criteria : criteria && f.role == Role::check;
  return judges && is_asked(f) && !f.is_beside;
}

/// Whether what is held against a part keeps to it: a field of the result, or of an element of its lists.
bool Run::keeps(const FieldInfo& f, const void* owner, bool criteria) const {
  return !is_held_against(f, criteria) || account::is_kept(f, f.get(owner));
}

/// Whether an element of a list passes its checks and keeps its criteria, or the limits of its methods.
bool Run::element_passes(const FieldInfo& list, void* element, bool criteria) const {
  return std::all_of(list.fields.begin(), list.fields.end(),
                     [&](const FieldInfo& f) { return keeps(f, element, criteria); });
}

/// What `passes` and `keeps_limits` say together, from one evaluation: of a part without positions.
bool Run::passes_covered() {
  if (positions() > 1) return passes() && keeps_limits(false);
  settle_sizes(settled_);
  if (first_broken_rule() < calculator_.rules.size() || !set_position(0)) return false;
  // Where the size is a result it was settled with these values of tables, and all results are there.
  if (find_field(calculator_.result->fields, size_field()) == nullptr)
    calculator_.evaluate(record_.data.get(), result_.data.get());
  const auto& fields = calculator_.result->fields;
  return std::all_of(fields.begin(), fields.end(), [&](const FieldInfo& f) {
    if (f.type != FieldInfo::Type::list)
      return keeps(f, result_.data.get(), true) && keeps(f, result_.data.get(), false);
    for (std::size_t k = 0; k < f.size(result_.data.get()); ++k) {
      void* const element = f.element(result_.data.get(), k);
      if (!element_passes(f, element, true) || !element_passes(f, element, false)) return false;
    }
    return true;
  });
}

/// The same of every element at every position.
bool Run::lists_pass(bool criteria) {
  const auto judges = [&](const FieldInfo& f) { return is_held_against(f, criteria); };
  for (const FieldInfo& list : calculator_.result->fields) {
    if (list.type != FieldInfo::Type::list || std::none_of(list.fields.begin(), list.fields.end(), judges)) continue;
    for (std::size_t i = 0; i < positions(); ++i) {
      if (!set_position(i)) continue;
      calculator_.evaluate(record_.data.get(), result_.data.get());
      for (std::size_t k = 0; k < list.size(result_.data.get()); ++k) {
        if (!element_passes(list, list.element(result_.data.get(), k), criteria)) return false;
      }
    }
  }
  return true;
}

/// Whether the criteria among the limits are kept, or those of the methods: what passes beyond its formulas is no size
/// to take.
bool Run::keeps_limits(bool criteria) {
  const auto& fields = calculator_.result->fields;
  return std::all_of(fields.begin(), fields.end(),
                     [&](const FieldInfo& f) {
                       return f.role != Role::limit || !is_asked(f) || f.is_beside || f.is_criterion != criteria ||
                              excused_.contains(&f) || !first_outside(f);
                     }) &&
         lists_pass(criteria);
}

/// The same of what is excused too.
bool Run::passes_whole() {
  const auto excused = std::exchange(excused_, {});
  const bool kept = passes() && keeps_limits(false);
  excused_ = excused;
  return kept;
}

/// The first value of a limit that is outside of it, or that is missing; nothing where it is kept.
std::optional<double> Run::first_outside(const FieldInfo& limit) {
  for (std::size_t i = 0; i < positions(); ++i) {
    if (!set_position(i)) continue;
    calculator_.evaluate(record_.data.get(), result_.data.get());
    const double si = limit.get(result_.data.get());
    if (!account::is_kept(limit, si)) return si;
  }
  return std::nullopt;
}

}  // namespace loadpath::project
