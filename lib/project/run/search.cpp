#include "lib/project/run/run.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

// The search for a size: the smallest value of a stock with which the step passes.
namespace loadpath::project {

bool Run::is_asked(const FieldInfo& check) const {
  std::string_view inputs = check.asked_by;
  if (inputs.empty()) return true;
  while (!inputs.empty()) {  // asked for every candidate of a search: no list of keys is made
    const std::string_view input = inputs.substr(0, inputs.find(", "));
    const Leaf asking = find_leaf(record_, input);
    if (asking && (!std::isnan(asking.get()) || comes_from_row(input, *asking.field))) return true;
    inputs.remove_prefix(std::min(input.size() + 2, inputs.size()));
  }
  return false;
}

/// Whether a row that the step names is to give the input, and must have it.
bool Run::comes_from_row(std::string_view input, const FieldInfo& field) const {
  return step_.names_row_for(std::string(input)) && !field.provider.may_lack;
}

/// The first rule about the input that is searched for that is broken at a position; none: past the last.
std::size_t Run::first_broken_rule() {
  const std::size_t count = calculator_.rules.size();
  const std::string& searched = step_.searches().front().path;
  for (std::size_t i = 0; i < positions(); ++i) {
    if (!set_position(i)) continue;
    for (std::size_t rule = 0; rule < count; ++rule) {
      if (calculator_.rules[rule].only_warns || !step_.is_about(rule, searched)) continue;
      if (!calculator_.holds(rule, record_.data.get())) return rule;
    }
  }
  return count;
}

bool Run::passes() {
  if (!settle_sizes() || first_broken_rule() < calculator_.rules.size()) return false;
  const auto& fields = calculator_.result->fields;
  return std::all_of(fields.begin(), fields.end(),
                     [&](const FieldInfo& f) {
                       if (f.role != Role::check || !is_asked(f) || f.is_beside) return true;
                       const double largest = largest_result(f);
                       return (largest >= -rounding && largest <= 1.0) || (f.where_set && std::isnan(largest));
                     }) &&
         keeps_limits(true);
}

/// Whether the criteria among the limits are kept, or those of the methods: what passes beyond its formulas is no size
/// to take.
bool Run::keeps_limits(bool criteria) {
  const auto& fields = calculator_.result->fields;
  return std::all_of(fields.begin(), fields.end(), [&](const FieldInfo& f) {
    if (f.role != Role::limit || !is_asked(f) || f.is_beside || f.is_criterion != criteria) return true;
    bool within = true;
    for (std::size_t i = 0; i < positions() && within; ++i) {
      if (!set_position(i)) continue;
      calculator_.evaluate(record_.data.get(), result_.data.get());
      const double si = f.get(result_.data.get());
      within = std::isnan(si) ? f.where_set : f.bounds.holds(si);
    }
    return within;
  });
}

/// The first of the values with which the step passes; `covered`: within all limits.
std::vector<double>::const_iterator Run::first_that_passes(const std::vector<double>& values, double least,
                                                           const Leaf& leaf, bool covered) {
  auto candidate =
      std::isnan(least) ? values.begin() : std::lower_bound(values.begin(), values.end(), least * (1.0 - 1e-12));
  for (; candidate != values.end(); ++candidate) {
    if (!leaf.field->bounds.holds(*candidate)) continue;
    leaf.set(*candidate);
    if ((passes() && (!covered || keeps_limits(false))) || lacks_needed_) break;
  }
  return candidate;
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

/// Sets the largest of the values with which every rule about it holds; false where none is, with the last one set.
bool Run::take_largest(const std::vector<double>& values, const Leaf& leaf) {
  const auto holds = [&](double value) {
    leaf.set(value);
    return first_broken_rule() == calculator_.rules.size();
  };
  if (std::any_of(values.rbegin(), values.rend(), holds)) return true;
  leaf.set(values.back());
  return false;
}

bool Run::search(std::vector<Issue>& issues) {
  if (step_.searches().empty()) return true;
  const Search& wanted = step_.searches().front();
  const Leaf leaf = map_leaf(wanted.path);
  settle_sizes();
  const FieldInfo* result = find_field(calculator_.result->fields, wanted.path);
  const double least = result == nullptr ? std::nan("") : largest_result(*result);
  if (result != nullptr && std::isnan(least)) return true;  // not even a least size: the checks say why
  if (result == nullptr && !is_any_asked()) {
    issues.push_back(aimless(wanted));
    return false;
  }
  keep_sizing_results(wanted.path);
  const std::vector<double> stock = stock_values(wanted.stock);
  auto candidate = first_that_passes(stock, least, leaf, true);
  if (candidate == stock.end()) candidate = first_that_passes(stock, least, leaf, false);
  if (candidate == stock.end() && !stock.empty() && !take_largest(stock, leaf)) {
    Issue issue = step_.broken_rule(first_broken_rule(), record_);
    issue.hint = say("{1} = {2}, the largest of {3}, was tried last", wanted.path,
                     format_quantity(stock.back(), leaf.field->unit), wanted.stock);
    issues.push_back(std::move(issue));
    return false;
  }
  Message found = say("smallest of {1} that passes every check", wanted.stock);
  if (lacks_needed_) found = say("first of {1} for which a value is missing", wanted.stock);
  if (candidate == stock.end()) found = say("largest of {1}; none passes", wanted.stock);
  origins_[wanted.path] = stock_origin(wanted.stock, std::move(found));
  return true;
}

}  // namespace loadpath::project
