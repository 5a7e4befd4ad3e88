#include "lib/project/run/evaluation/evaluation.hpp"

#include "lib/project/run/evaluation/searched_rules.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::project {

namespace {

constexpr double not_available = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Evaluation::Evaluation(const PreparedStep& step, const Known& known)
    : step_(step), calculator_(*step.input().calculator), inputs_(step, known), result_(*calculator_.result) {}

Issue Evaluation::broken_rule(std::size_t rule) const { return step_.broken_rule(rule, record(), inputs_.provided()); }

bool Evaluation::check_rules(std::vector<Issue>& issues) {
  inputs_.set_values_of_rows(first_size());
  std::vector<std::size_t> rules;
  for (std::size_t rule = 0; rule < calculator_.rules.size(); ++rule) {
    if (!waits_for_search(step_, rule)) rules.push_back(rule);
  }
  std::set<std::size_t> warned;  // a warning is reported once, not at every position
  for (std::size_t i = 0; i < positions(); ++i) {
    if (!set_position(i)) continue;
    for (const std::size_t rule : rules) {
      if (holds(rule)) continue;
      if (calculator_.rules[rule].only_warns && !warned.insert(rule).second) continue;
      issues.push_back(broken_rule(rule));
      if (!calculator_.rules[rule].only_warns) return false;
    }
  }
  return true;
}

double Evaluation::size_now() {
  const std::string_view path = inputs_.size_field();
  if (const FieldInfo* result = find_field(calculator_.result->fields, path)) return largest_result(*result);
  if (const ComputedInput* const input = inputs_.find_computed(path))
    return input->value.is_series() ? maximum(input->value).value : input->value.si[0];
  const Leaf given = inputs_.leaf(path);
  return given ? given.get() : not_available;
}

/// A size that follows from the values, or is searched for, starts at zero.
double Evaluation::first_size() {
  const std::string_view path = inputs_.size_field();
  if (path.empty()) return not_available;
  const auto& searches = step_.searches();
  const bool is_found = find_field(calculator_.result->fields, path) != nullptr ||
                        std::any_of(searches.begin(), searches.end(), [&](const Search& s) { return s.path == path; });
  return is_found ? 0.0 : size_now();
}

/// A strength falls with the size that it is looked up at, so the size only grows from one round to the next. If a
/// row is stronger at a larger size it may alternate: then no size is consistent with the values at itself.
void Evaluation::settle_sizes_from(double size) {
  unsettled_ = {};
  if (inputs_.size_field().empty()) {
    inputs_.set_values_of_rows(not_available);
    return;
  }
  double before = size, two_before = size;
  for (int round = 0; round < most_size_rounds; ++round) {
    const bool changed = inputs_.set_values_of_rows(size);
    settled_ = size;
    if (round > 0 && !changed) return;  // the same values give the same size
    const double next = size_now();
    if (std::isnan(next) || next == size) return;  // without a size something is not available; the checks report it
    two_before = before;
    before = size;
    size = next;
  }
  unsettled_ = unsettled_size(two_before, before, size);
}

/// Only a result changes between rounds.
Message Evaluation::unsettled_size(double two_before, double before, double now) const {
  const FieldInfo& field = *find_field(calculator_.result->fields, inputs_.size_field());
  const auto shown = [&](double si) { return format_quantity(si, field.unit, 4); };
  return now == two_before ? say("the size '{1}' does not converge: it alternates between {2} and {3}", field.key,
                                 shown(std::min(before, now)), shown(std::max(before, now)))
                           : say("the size '{1}' does not converge: after {2} rounds it goes from {3} to {4}",
                                 field.key, std::to_string(most_size_rounds), shown(before), shown(now));
}

bool Evaluation::evaluate_at(std::size_t i) {
  if (!set_position(i)) return false;
  if (remembers_results())
    evaluate_or_remember();
  else
    evaluate_record();
  return true;
}

/// A search comes back to parts that have several sizes, one of which the tables need: of one position.
bool Evaluation::remembers_results() const {
  const bool has_sizes = *calculator_.sizing.list != '\0';
  return has_sizes && positions() == 1 && find_field(calculator_.result->fields, inputs_.size_field()) != nullptr;
}

void Evaluation::evaluate_or_remember() {
  RecordState state = state_of(record(), inputs_.provided());
  if (evaluated_ == state) return;
  if (const Record* const known = evaluated_records_.find(state)) {
    result_.type->copy(known->data.get(), result_.data.get());
  } else {
    evaluate_record();
    evaluated_records_.add(state, result_.clone());
  }
  evaluated_ = std::move(state);
}

double Evaluation::largest_result(const FieldInfo& field) {
  Value column{{field.dimension, axis()}, {}};
  for (std::size_t i = 0; i < positions(); ++i)
    column.si.push_back(evaluate_at(i) ? field.get(result_.data.get()) : not_available);
  return axis() == nullptr ? column.si[0] : maximum(column).value;
}

bool Evaluation::is_judged(const FieldInfo& field) const {
  const bool judges = field.role == Role::check || field.role == Role::limit;
  return judges && !field.is_informative && is_asked(field);
}

}  // namespace loadpath::project
