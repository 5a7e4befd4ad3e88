#include "lib/project/run/search/largest_search.hpp"

#include "lib/project/run/search/remarks.hpp"
#include "lib/project/run/search/shortfall.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

constexpr double growth = 1.25;       // between the values that are tried first
constexpr double least_share = 1e-9;  // relative to the largest one
constexpr int digits = 4;             // digits of the result

/// The number of four digits that is not larger.
double rounded_down(double value, double unit) {
  const double number = value / unit;
  const double one = std::pow(10.0, std::floor(std::log10(number)) + 1.0 - digits);
  return std::floor(number / one * (1.0 + 1e-12)) * one * unit;
}

/// The limit of plausible values; in SI.
double largest_of(const FieldInfo& field) {
  const double usual = std::isinf(field.plausible.high) ? 1e6 * field.factor : 10.0 * field.plausible.high;
  return std::min(usual, field.bounds.high);
}

}  // namespace

bool LargestSearch::passes_with(double value) {
  leaf_.set(value);
  return leaf_.field->bounds.holds(value) && passing_.passes();
}

/// The largest value up to which all that are tried pass, from the least one that does; between it and the next, by
/// halves.
void LargestSearch::run(bool in_words, std::vector<Issue>& issues) {
  const double most = largest_of(*leaf_.field);
  double low = most * least_share;
  leaf_.set(low);  // checks are active only with a load
  if (!passing_.is_any_asked()) return issues.push_back(aimless_search(evaluation_.step(), wanted_));
  while (low < most && !passes_with(low)) low *= growth;
  if (low >= most && excuse_unmoved(most)) {
    low = most * least_share;
    while (low < most && !passes_with(low)) low *= growth;
  }
  if (low >= most) return report_none(most * least_share, issues);
  double high = low * growth;
  for (; high < most && passes_with(high); high *= growth) low = high;
  if (high >= most) {
    return issues.push_back(issue_at(evaluation_.step().input(), wanted_.path,
                                     say("'{1}' has no largest value: it passes up to {2}", wanted_.path,
                                         format_quantity(most, leaf_.field->unit, digits)),
                                     say("give what limits it, or a value")));
  }
  while (high > low * (1.0 + 1e-6)) {
    const double middle = 0.5 * (low + high);
    (passes_with(middle) ? low : high) = middle;
  }
  keep(low);
  if (!in_words) return;
  warn_of_customs(evaluation_, issues);
  warn_of_found(evaluation_, wanted_, issues);
}

/// Ignores ranges of methods that are exceeded for any load.
bool LargestSearch::excuse_unmoved(double most) {
  const auto failed_with = [&](double value) {
    passes_with(value);
    return failed_values(evaluation_, passing_);
  };
  const FailedValues small = failed_with(most * least_share), larger = failed_with(most * std::sqrt(least_share));
  std::size_t excused = 0;
  for (const auto& [row, value] : unmoved_values(small, larger)) {
    if (is_failure(*row.field)) continue;  // with any load the part fails
    passing_.excuse(row);
    ++excused;
  }
  return excused > 0;
}

/// Rounds down to four digits: the largest such number that passes.
void LargestSearch::keep(double largest) {
  const double unit = leaf_.field->factor;
  const double next = rounded_down(largest * (1.0 + 2e-6), unit);  // the halving stops a little below the limit
  const double rounded = next > largest && passes_with(next) ? next : rounded_down(largest, unit);
  leaf_.set(1.01 * rounded);
  const Message beyond = fault_of_candidate(evaluation_, passing_).text;
  if (!passes_with(rounded)) leaf_.set(largest);
  evaluation_.inputs().set_origin(
      wanted_.path, {say("maximum with which no assessed mode fails; 1 % more: {1}", beyond), {}, false, true});
}

/// Without a value there is neither a result nor a verdict.
void LargestSearch::report_none(double value, std::vector<Issue>& issues) {
  leaf_.set(value);
  if (const auto rule = passing_.first_broken_rule()) return issues.push_back(evaluation_.broken_rule(*rule));
  evaluation_.inputs().set_unavailable(
      say("no '{1}' passes: at {2} {3}", wanted_.path, format_quantity(value, leaf_.field->unit, digits),
          fault_of_candidate(evaluation_, passing_).text),
      account::Subject::search);
  leaf_.set(std::nan(""));
}

}  // namespace loadpath::project
