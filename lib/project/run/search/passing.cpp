#include "lib/project/run/search/passing.hpp"

#include "lib/account/rows.hpp"
#include "lib/project/run/evaluation/searched_rules.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::project {

const std::vector<bool>& Passing::concerned() {
  const std::size_t count = evaluation_.calculator().rules.size();
  for (std::size_t rule = concerned_.size(); rule < count; ++rule)  // once, not for every candidate
    concerned_.push_back(must_hold_in_search(evaluation_.step(), rule));
  return concerned_;
}

std::optional<std::size_t> Passing::first_broken_rule() {
  const std::vector<bool>& concerned = this->concerned();
  for (std::size_t i = 0; i < evaluation_.positions(); ++i) {
    if (!evaluation_.set_position(i)) continue;
    for (std::size_t rule = 0; rule < concerned.size(); ++rule) {
      if (concerned[rule] && !evaluation_.holds(rule)) return rule;
    }
  }
  return std::nullopt;
}

bool Passing::takes_sized_value(std::size_t rule) const {
  const auto fields = listed_keys(evaluation_.calculator().rules[rule].fields);
  const auto& provided = evaluation_.inputs().provided();
  return std::any_of(provided.begin(), provided.end(), [&](const Provided& value) {
    const bool depends_on_size = *value.field->provider.size != '\0';
    return depends_on_size && std::find(fields.begin(), fields.end(), value.path) != fields.end();
  });
}

bool Passing::breaks_rule_without_table() {
  const std::vector<bool>& concerned = this->concerned();
  for (std::size_t i = 0; i < evaluation_.positions(); ++i) {
    if (!evaluation_.inputs().set_position(i)) continue;
    for (std::size_t rule = 0; rule < concerned.size(); ++rule) {
      if (concerned[rule] && !evaluation_.holds(rule) && !takes_sized_value(rule)) return true;
    }
  }
  return false;
}

bool Passing::has_rule_with_table() {
  const std::vector<bool>& concerned = this->concerned();
  for (std::size_t rule = 0; rule < concerned.size(); ++rule) {
    if (concerned[rule] && takes_sized_value(rule)) return true;
  }
  return false;
}

bool Passing::settles_within_rules() {
  if (breaks_rule_without_table()) return false;
  evaluation_.settle_sizes_again();
  return keeps_rules();
}

std::set<std::size_t> Passing::broken_rules() {
  const std::vector<bool>& concerned = this->concerned();
  std::set<std::size_t> broken;
  if (has_rule_with_table()) evaluation_.settle_sizes_again();
  for (std::size_t i = 0; i < evaluation_.positions(); ++i) {
    if (!evaluation_.inputs().set_position(i)) continue;
    for (std::size_t rule = 0; rule < concerned.size(); ++rule) {
      if (concerned[rule] && !evaluation_.holds(rule)) broken.insert(rule);
    }
  }
  return broken;
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

/// A candidate that fails does so mostly at the position where the one before failed.
bool Passing::passes() {
  evaluation_.settle_sizes();
  if (!keeps_rules()) return false;
  const bool is_first = failed_at_ == 0 || failed_at_ >= evaluation_.positions();
  if (!is_first && evaluation_.evaluate_at(failed_at_) && !holds_here()) return false;
  std::vector<std::pair<const FieldInfo*, Value>> checks;
  for (const FieldInfo& f : evaluation_.calculator().result->fields) {
    if (f.role == Role::check && counts({&f})) checks.emplace_back(&f, Value{{f.dimension, evaluation_.axis()}, {}});
  }
  for (std::size_t i = 0; i < evaluation_.positions(); ++i) {
    const bool is_available = evaluation_.evaluate_at(i);
    if (is_available && !holds_here()) return failed_at_ = i, false;
    for (auto& [check, column] : checks)
      column.si.push_back(is_available ? check->get(evaluation_.result().data.get()) : std::nan(""));
  }
  return std::all_of(checks.begin(), checks.end(), [](const auto& check) {  // between the positions, too
    const Value& column = check.second;
    return account::is_kept(*check.first, column.is_series() ? maximum(column).value : column.si[0]);
  });
}

/// Whether nothing fails as it is evaluated now; a check without a value may have one at other positions.
bool Passing::holds_here() const {
  void* const result = evaluation_.result().data.get();
  const auto& fields = evaluation_.calculator().result->fields;
  return std::all_of(fields.begin(), fields.end(), [&](const FieldInfo& f) {
    if (f.type == FieldInfo::Type::list) {
      for (std::size_t k = 0; k < f.size(result); ++k) {
        if (!element_passes(f, k)) return false;
      }
      return true;
    }
    if (f.role != Role::check && f.role != Role::limit) return true;
    const double si = f.get(result);
    return (f.role == Role::check && std::isnan(si)) || account::is_kept(f, si) || !counts({&f});
  });
}

bool Passing::passes_again() {
  if (evaluation_.positions() > 1) return passes();
  if (!settles_within_rules() || !evaluation_.evaluate_at(0)) return false;
  const auto& fields = evaluation_.calculator().result->fields;
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

std::optional<double> Passing::first_outside(const FieldInfo& limit) {
  for (std::size_t i = 0; i < evaluation_.positions(); ++i) {
    if (!evaluation_.evaluate_at(i)) continue;
    const double si = limit.get(evaluation_.result().data.get());
    if (!account::is_kept(limit, si)) return si;
  }
  return std::nullopt;
}

}  // namespace loadpath::project
