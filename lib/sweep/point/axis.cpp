#include "lib/sweep/point/axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace loadpath::sweep {

namespace {

// A double distinguishes this many values, and those of a logarithmic axis are kept.
constexpr double most_values = 0x1p53;
constexpr std::uint64_t most_kept = 10'000'000;

Fault refused(Message message, Message hint = {}) { return {0, 1, std::move(message), std::move(hint)}; }

// Values times their number stay numbers.
bool are_numbers(double a, double b) { return std::abs(a) < 1e290 && std::abs(b) < 1e290; }

struct Steps {
  double count;
  bool meet;  // the end, within the rounding of ends and step
};
Steps steps_between(double from, double to, double step) {
  if (from == to) return {0.0, true};
  const double steps = (to - from) / step, nearest = std::round(steps);
  const double rounding =
      16.0 * std::numeric_limits<double>::epsilon() * ((std::abs(from) + std::abs(to)) / std::abs(step) + steps);
  return std::abs(steps - nearest) <= std::min(rounding, 1e-3) ? Steps{nearest, true} : Steps{std::floor(steps), false};
}

Fault no_range() { return refused(say("the ends of a range must be numbers below 1e290")); }

}  // namespace

Outcome<Axis> Axis::list(std::vector<double> values) {
  if (values.empty()) return refused(say("the list of values is empty"));
  for (const double value : values) {
    if (!std::isfinite(value)) return refused(say("the values must be numbers"));
  }
  Axis axis;
  axis.size_ = values.size();
  axis.values_ = std::move(values);
  return axis;
}

Outcome<Axis> Axis::by_step(double from, double to, double step) {
  if (!are_numbers(from, to) || !std::isfinite(step)) return no_range();
  if (step == 0.0) return refused(say("the step must not be zero"));
  const Steps steps = steps_between(from, to, step);
  if (steps.count < 0.0) return refused(say("the step leads away from the end of the range"), say("change its sign"));
  if (!(steps.count < most_values)) return refused(say("the step is too small for the range"));
  Axis axis;
  axis.from_ = from;
  axis.to_ = to;
  axis.step_ = step;
  axis.size_ = static_cast<std::uint64_t>(steps.count) + 1;
  axis.last_ = steps.meet ? to : from + steps.count * step;
  return axis;
}

Outcome<Axis> Axis::by_count(double from, double to, std::uint64_t count) {
  if (!are_numbers(from, to)) return no_range();
  if (count < 2) return refused(say("a range has 2 values at least"));
  if (!(static_cast<double>(count) < most_values)) return refused(say("the range has too many values"));
  Axis axis;
  axis.from_ = from;
  axis.to_ = axis.last_ = to;
  axis.size_ = count;
  return axis;
}

Outcome<Axis> Axis::logarithmic(double from, double to, std::uint64_t count) {
  if (!are_numbers(from, to)) return no_range();
  if (!(from * (to / std::abs(to)) > 0.0))
    return refused(say("the ends of a logarithmic range must be of one sign, and not zero"));
  if (count < 2) return refused(say("a range has 2 values at least"));
  if (count > most_kept) return refused(say("a logarithmic range has {1} values at most", std::to_string(most_kept)));
  // In extended precision, so that decades give the intended decimal number.
  const long double ratio = std::log(static_cast<long double>(to) / from);
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] =
        static_cast<double>(from * std::exp(ratio * static_cast<long double>(i) / static_cast<long double>(count - 1)));
  values.back() = to;
  return list(std::move(values));
}

double Axis::at(std::uint64_t i) const {
  if (!values_.empty()) return values_[i];
  if (i + 1 == size_) return last_;
  const double steps = static_cast<double>(i), all = static_cast<double>(size_ - 1);
  if (step_ != 0.0) return from_ + steps * step_;
  return i == 0 ? from_ : (from_ * (all - steps) + to_ * steps) / all;
}

}  // namespace loadpath::sweep
