#include "lib/project/run/search/passing.hpp"

#include "lib/account/rows.hpp"
#include "lib/project/run/evaluation/searched_rules.hpp"

#include <algorithm>

namespace loadpath::project {

std::optional<std::size_t> Passing::first_broken_rule() {
  const Calculator& calculator = evaluation_.calculator();
  const std::size_t count = calculator.rules.size();
  for (std::size_t rule = concerned_.size(); rule < count; ++rule)  // once, not for every candidate
    concerned_.push_back(must_hold_in_search(evaluation_.step(), rule));
  for (std::size_t i = 0; i < evaluation_.positions(); ++i) {
    if (!evaluation_.set_position(i)) continue;
    for (std::size_t rule = 0; rule < count; ++rule) {
      if (concerned_[rule] && !evaluation_.holds(rule)) return rule;
    }
  }
  return std::nullopt;
}

bool Passing::is_any_asked() const {
  const auto& fields = evaluation_.calculator().result->fields;
  return std::any_of(fields.begin(), fields.end(),
                     [&](const FieldInfo& f) { return f.role == Role::check && evaluation_.is_judged(f); });
}

bool Passing::counts(const Row& row) const {
  return evaluation_.is_judged(*row.field) && !excused_.contains(row) && !excused_.contains({row.field, Row::of_all});
}

void Passing::excuse_sizeless() {
  for (const FieldInfo& f : evaluation_.calculator().result->fields) {
    if (f.is_sizeless) excuse({&f});
    for (const FieldInfo& of_element : f.fields) {
      if (f.type == FieldInfo::Type::list && of_element.is_sizeless) excuse({&of_element, Row::of_all});
    }
  }
}

bool Passing::passes() {
  evaluation_.settle_sizes();
  if (!keeps_rules()) return false;
  const auto& fields = evaluation_.calculator().result->fields;
  return std::all_of(fields.begin(), fields.end(),
                     [&](const FieldInfo& f) {
                       return f.role != Role::check || !counts({&f}) ||
                              account::is_kept(f, evaluation_.largest_result(f));
                     }) &&
         keeps_limits(true) && keeps_limits(false);
}

bool Passing::passes_again() {
  if (evaluation_.positions() > 1) return passes();
  evaluation_.settle_sizes_again();
  if (!keeps_rules() || !evaluation_.set_position(0)) return false;
  // If the size is a result it was settled with these values of tables, and all results are available.
  const auto& fields = evaluation_.calculator().result->fields;
  if (find_field(fields, evaluation_.inputs().size_field()) == nullptr) evaluation_.evaluate_record();
  void* const result = evaluation_.result().data.get();
  return std::all_of(fields.begin(), fields.end(), [&](const FieldInfo& f) {
    if (excused_.contains({&f})) return true;
    if (f.type != FieldInfo::Type::list) return keeps(f, result, true) && keeps(f, result, false);
    for (std::size_t k = 0; k < f.size(result); ++k) {
      if (!element_passes(f, k)) return false;
    }
    return true;
  });
}

/// Whether a field is a check or a criterion, or the limit of a method.
bool Passing::is_held_against(const FieldInfo& f, bool criteria) const {
  const bool judges = f.role == Role::limit ? f.is_criterion == criteria : criteria && f.role == Role::check;
  return judges && evaluation_.is_judged(f);
}

bool Passing::keeps(const FieldInfo& f, const void* owner, bool criteria) const {
  return !is_held_against(f, criteria) || account::is_kept(f, f.get(owner));
}

bool Passing::element_keeps(const FieldInfo& list, std::size_t k, bool criteria) const {
  void* const element = list.element(evaluation_.result().data.get(), k);
  return std::all_of(list.fields.begin(), list.fields.end(), [&](const FieldInfo& f) {
    return keeps(f, element, criteria) || !counts({&f, k});
  });
}

bool Passing::element_passes(const FieldInfo& list, std::size_t k) const {
  return element_keeps(list, k, true) && element_keeps(list, k, false);
}

/// The same of every element at every position.
bool Passing::lists_pass(bool criteria) {
  const auto judges = [&](const FieldInfo& f) { return is_held_against(f, criteria); };
  for (const FieldInfo& list : evaluation_.calculator().result->fields) {
    if (list.type != FieldInfo::Type::list || std::none_of(list.fields.begin(), list.fields.end(), judges)) continue;
    for (std::size_t i = 0; i < evaluation_.positions(); ++i) {
      if (!evaluation_.evaluate_at(i)) continue;
      void* const result = evaluation_.result().data.get();
      for (std::size_t k = 0; k < list.size(result); ++k) {
        if (!element_keeps(list, k, criteria)) return false;
      }
    }
  }
  return true;
}

/// Whether the criteria among the limits are kept, or those of the methods.
bool Passing::keeps_limits(bool criteria) {
  const auto& fields = evaluation_.calculator().result->fields;
  return std::all_of(fields.begin(), fields.end(),
                     [&](const FieldInfo& f) {
                       return f.role != Role::limit || f.is_criterion != criteria || !counts({&f}) || !first_outside(f);
                     }) &&
         lists_pass(criteria);
}

std::optional<double> Passing::first_outside(const FieldInfo& limit) {
  for (std::size_t i = 0; i < evaluation_.positions(); ++i) {
    if (!evaluation_.evaluate_at(i)) continue;
    const double si = limit.get(evaluation_.result().data.get());
    if (!account::is_kept(limit, si)) return si;
  }
  return std::nullopt;
}

}  // namespace loadpath::project
