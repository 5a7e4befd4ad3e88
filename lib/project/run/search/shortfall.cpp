#include "lib/project/run/search/shortfall.hpp"

#include "lib/numerics/magnitude.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace loadpath::project {

namespace {

/// With as many digits as tell that it is above 1.
std::string beyond_one(double utilisation) {
  int precision = 4;
  while (precision < 12 && format_number(utilisation, precision) == "1") ++precision;
  return format_number(utilisation, precision);
}

/// How far beyond its bounds a value is, as a factor; 1 within them.
double excess_over(const Range& bounds, double si) {
  if (std::isnan(si)) return std::numeric_limits<double>::infinity();
  if (bounds.holds(si)) return 1.0;
  const double large = std::abs(si > bounds.high ? si : bounds.low);
  const double small = std::abs(si > bounds.high ? bounds.high : si);
  return small > 0.0 ? std::max(1.0, large / small) : std::numeric_limits<double>::infinity();
}

/// Adds what elements of a list lack, as they were evaluated last.
void add_shortfall_of(const Evaluation& evaluation, const FieldInfo& list, Shortfall& shortfall) {
  void* const result = evaluation.result().data.get();
  for (std::size_t k = 0; k < list.size(result); ++k) {
    for (const FieldInfo& f : list.fields) {
      if (!evaluation.is_judged(f)) continue;
      const double si = f.get(list.element(result, k));
      if (std::isnan(si)) continue;  // what has no value is told by the limits
      double& most = f.role == Role::check || f.is_criterion ? shortfall.check : shortfall.limit;
      most = std::max(most, f.role == Role::check ? si : excess_over(f.bounds, si));
    }
  }
}

/// The check in a list that is beyond 1 most, and beyond `most`; empty where none is.
Message fault_of_lists(Evaluation& evaluation, double most) {
  Message worst;
  for (std::size_t i = 0; i < evaluation.positions(); ++i) {
    if (!evaluation.evaluate_at(i)) continue;
    for_each_leaf(evaluation.result(), [&](const std::string& path, const Leaf& leaf) {
      const bool listed = path.find('.') != std::string::npos;
      if (!listed || leaf.field->role != Role::check || !evaluation.is_judged(*leaf.field)) return;
      if (!numerics::exceeds(leaf.get(), most)) return;
      most = leaf.get();
      worst = say("{1} = {2}", path, beyond_one(most));
    });
  }
  return worst;
}

/// The first limit that is not kept, of the criteria before those of the methods.
Message fault_of_limits(const Evaluation& evaluation, Passing& passing) {
  for (const bool criteria : {true, false}) {
    for (const FieldInfo& f : evaluation.calculator().result->fields) {
      if (f.role != Role::limit || f.is_criterion != criteria || !passing.counts(f)) continue;
      if (const auto bad = passing.first_outside(f))
        return std::isnan(*bad) ? say("{1} is not available", f.key)
                                : say("{1} = {2}: {3}", f.key, format_quantity(*bad, f.unit, 4), bounds_message(f));
    }
  }
  const Message& gap = evaluation.inputs().table_gap();
  return gap.empty() ? say("a check has no value") : gap;
}

/// The largest value of a check that is not passed; nothing where it is.
std::optional<double> failed_value(Evaluation& evaluation, const FieldInfo& check) {
  const double largest = evaluation.largest_result(check);
  return numerics::exceeds(largest, 1.0) ? std::optional(largest) : std::nullopt;
}

/// Whether what fails with the smallest and the largest candidate is no better with the largest.
bool is_unmoved(const FieldInfo& field, double with_smallest, double with_largest) {
  const double change = with_largest - with_smallest, rounding = 1e-9 * std::abs(with_largest);
  return field.role == Role::check ? change >= -rounding : std::abs(change) <= rounding;
}

}  // namespace

FailedValues failed_values(Evaluation& evaluation, Passing& passing) {
  FailedValues outside;
  for (const FieldInfo& f : evaluation.calculator().result->fields) {
    if (!passing.counts(f)) continue;
    const auto bad = f.role == Role::limit ? passing.first_outside(f) : failed_value(evaluation, f);
    if (bad && !std::isnan(*bad)) outside[&f] = *bad;
  }
  return outside;
}

FailedValues unmoved_values(const FailedValues& smaller, const FailedValues& larger) {
  FailedValues unmoved;
  for (const auto& [field, value] : larger) {
    const auto same = smaller.find(field);
    if (same != smaller.end() && is_unmoved(*field, same->second, value)) unmoved.emplace(field, value);
  }
  return unmoved;
}

/// A check without a value counts where no limit says why.
Shortfall shortfall_of_candidate(Evaluation& evaluation, Passing& passing) {
  Shortfall shortfall;
  bool missing = false;
  for (const FieldInfo& f : evaluation.calculator().result->fields) {
    for (std::size_t i = 0; i < evaluation.positions() && f.type == FieldInfo::Type::list; ++i) {
      if (evaluation.evaluate_at(i)) add_shortfall_of(evaluation, f, shortfall);
    }
    if (!passing.counts(f)) continue;
    if (f.role == Role::check) {
      const double largest = evaluation.largest_result(f);
      missing = missing || (std::isnan(largest) && !f.where_set);
      if (numerics::exceeds(largest, shortfall.check)) shortfall.check = largest;
    } else if (const auto bad = passing.first_outside(f)) {
      shortfall.limit = std::max(shortfall.limit, excess_over(f.bounds, *bad));
      if (f.is_criterion) shortfall.check = std::max(shortfall.check, shortfall.limit);
    }
  }
  if (missing && shortfall.limit <= 1.0) shortfall.check = std::numeric_limits<double>::infinity();
  return shortfall;
}

Message fault_of_candidate(Evaluation& evaluation, Passing& passing) {
  evaluation.settle_sizes();
  if (!evaluation.is_settled()) return evaluation.unsettled();
  if (const auto rule = passing.first_broken_rule()) return evaluation.broken_rule(*rule).message;
  const bool is_single = evaluation.axis() == nullptr;  // from one evaluation
  if (is_single) evaluation.evaluate_at(0);
  const FieldInfo* worst = nullptr;  // a check without a value may be so for a limit that is not kept
  double most = 1.0;
  for (const FieldInfo& f : evaluation.calculator().result->fields) {
    if (f.role != Role::check || !passing.counts(f)) continue;
    const double largest = is_single ? f.get(evaluation.result().data.get()) : evaluation.largest_result(f);
    if (!numerics::exceeds(largest, most)) continue;
    worst = &f;
    most = largest;
  }
  if (const Message listed = fault_of_lists(evaluation, most); !listed.empty()) return listed;
  if (worst != nullptr) return say("{1} = {2}", worst->key, beyond_one(most));
  return fault_of_limits(evaluation, passing);
}

}  // namespace loadpath::project
