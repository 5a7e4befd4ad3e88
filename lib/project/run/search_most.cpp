// The search for the largest value of a load, a length, a speed with which a step passes.
#include "lib/project/run/run.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

constexpr double growth = 1.25;       // between the values that are tried first
constexpr double least_share = 1e-9;  // of the largest one
constexpr int digits = 4;             // of what is found

/// The number of four digits that is not larger.
double rounded_down(double value, double unit) {
  const double number = value / unit;
  const double one = std::pow(10.0, std::floor(std::log10(number)) + 1.0 - digits);
  return std::floor(number / one * (1.0 + 1e-12)) * one * unit;
}

/// Beyond it no machine has such a value; in SI.
double largest_of(const FieldInfo& field) {
  const double usual = std::isinf(field.plausible.high) ? 1e6 * field.factor : 10.0 * field.plausible.high;
  return std::min(usual, field.bounds.high);
}

}  // namespace

bool Run::passes_with(const Leaf& leaf, double value) {
  leaf.set(value);
  return leaf.field->bounds.holds(value) && passes() && keeps_limits(false);
}

/// The largest value up to which all that are tried pass, from the least one that does; between it and the next, by
/// halves.
void Run::search_most(const Search& wanted, std::vector<Issue>& issues) {
  const Leaf leaf = map_leaf(wanted.path);
  const double most = largest_of(*leaf.field);
  double low = most * least_share;
  leaf.set(low);  // a load is what asks for its checks
  if (!is_any_asked()) return issues.push_back(aimless(wanted));
  while (low < most && !passes_with(leaf, low)) low *= growth;
  if (low >= most) return tell_none(wanted, most * least_share, issues);
  double high = low * growth;
  for (; high < most && passes_with(leaf, high); high *= growth) low = high;
  if (high >= most) {
    return issues.push_back(issue_at(step_.input(), wanted.path,
                                     say("'{1}' has no largest value: it passes up to {2}", wanted.path,
                                         format_quantity(most, leaf.field->unit, digits)),
                                     say("give what limits it, or a value")));
  }
  while (high > low * (1.0 + 1e-6)) {
    const double middle = 0.5 * (low + high);
    (passes_with(leaf, middle) ? low : high) = middle;
  }
  const double found = rounded_down(low, leaf.field->factor);
  leaf.set(1.01 * found);
  const Message beyond = fault_of_candidate();
  if (!passes_with(leaf, found)) leaf.set(low);
  origins_[wanted.path] = {say("largest that passes every check; 1 % more: {1}", beyond), {}, false, true};
  if (in_words_) warn_of_found(wanted, issues);
}

/// Without a value there is no result, and no verdict.
void Run::tell_none(const Search& wanted, double value, std::vector<Issue>& issues) {
  const Leaf leaf = map_leaf(wanted.path);
  leaf.set(value);
  if (const std::size_t rule = first_broken_rule(); rule < calculator_.rules.size())
    return issues.push_back(step_.broken_rule(rule, record_, provided_));
  not_given_ = say("no '{1}' passes: at {2} {3}", wanted.path, format_quantity(value, leaf.field->unit, digits),
                   fault_of_candidate());
  leaf.set(std::nan(""));
}

}  // namespace loadpath::project
