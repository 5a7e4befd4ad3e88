#include "lib/quantity/series.hpp"

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace loadpath {
namespace {

constexpr double not_available = std::numeric_limits<double>::quiet_NaN();

struct Point {
  double at = 0.0;
  double value = 0.0;
};

/// The position `k` of a series, counted on through neighbouring turns of a cycle.
Point point(const Value& series, std::ptrdiff_t k) {
  const Axis& axis = *series.signature.axis;
  const auto n = static_cast<std::ptrdiff_t>(axis.at.size());
  const std::ptrdiff_t turn = k >= 0 ? k / n : (k + 1) / n - 1;
  const auto i = static_cast<std::size_t>(k - turn * n);
  return {axis.at[i] + static_cast<double>(turn) * axis.period, series.si[i]};
}

bool over_a_cycle(const Value& series) {
  const Axis* axis = series.signature.axis;
  return axis != nullptr && axis->cyclic() && axis->at.size() == series.si.size() && !series.si.empty();
}

/// The place within the axis: brought into the listed turn of a cycle; nothing outside an open axis.
std::optional<double> place_on(const Axis& axis, double at) {
  const double first = axis.at.front();
  if (axis.cyclic()) {
    const double turns = (at - first) / axis.period;
    return first + (turns - std::floor(turns)) * axis.period;
  }
  const auto [low, high] = std::minmax({first, axis.at.back()});
  // The last position is computed, the place is typed: they may differ in the last digits.
  const double slack = 1e-9 * (high - low);
  if (!(at >= low - slack && at <= high + slack)) return {};
  return std::clamp(at, low, high);
}

/// The index of the position at or before a place, in the direction of the axis.
std::ptrdiff_t position_before(const Axis& axis, double at) {
  const bool descending = axis.cyclic() ? axis.period < 0.0 : axis.at.back() < axis.at.front();
  const auto is_reached = [&](std::size_t i) { return descending ? axis.at[i] >= at : axis.at[i] <= at; };
  const boost::counting_iterator<std::size_t> first(0), last(axis.at.size());
  return std::max<std::ptrdiff_t>(std::partition_point(first, last, is_reached) - first - 1, 0);
}

double interpolated(const std::array<Point, 4>& points, std::size_t count, double at) {
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    double weight = 1.0;
    for (std::size_t m = 0; m < count; ++m) {
      if (m != k) weight *= (at - points[m].at) / (points[k].at - points[m].at);
    }
    sum += weight * points[k].value;
  }
  return sum;
}

}  // namespace

bool resolves_extremes(const Value& series) {
  constexpr std::size_t fewest = 36;
  constexpr double most_missed = 0.01;
  if (!series.is_series() || !series.signature.axis->cyclic()) return true;
  const double top = maximum(series).value;
  if (std::isnan(top) || is_constant(series)) return true;
  const auto [least, largest] = std::minmax_element(series.si.begin(), series.si.end());
  const double missed = std::max(top - *largest, *least - minimum(series).value);
  return series.si.size() >= fewest && missed <= most_missed * (*largest - *least);
}

bool is_constant(const Value& series) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double x : series.si) {
    if (std::isnan(x)) return false;
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return !series.si.empty() && high - low <= series.rounding;
}

double mean(const Value& series) {
  if (!over_a_cycle(series)) return not_available;
  const auto& share = series.signature.axis->share;
  if (share.size() != series.si.size()) return not_available;
  double sum = 0.0;
  for (std::size_t i = 0; i < share.size(); ++i) sum += share[i] * series.si[i];
  return sum;
}

double root_mean_square(const Value& series) {
  Value square = series;
  for (double& x : square.si) x *= x;
  return std::sqrt(mean(square));
}

double value_at(const Value& series, double at) {
  const Axis* axis = series.signature.axis;
  if (axis == nullptr || series.si.empty() || axis->at.size() != series.si.size()) return not_available;
  const auto place = place_on(*axis, at);
  if (!place) return not_available;
  const auto n = static_cast<std::ptrdiff_t>(series.si.size());
  const auto count = axis->cyclic() ? 4 : std::min<std::ptrdiff_t>(4, n);
  auto first = position_before(*axis, *place) - 1;
  if (!axis->cyclic()) first = std::clamp<std::ptrdiff_t>(first, 0, n - count);

  std::array<Point, 4> points{};
  for (std::ptrdiff_t k = 0; k < count; ++k) points[static_cast<std::size_t>(k)] = point(series, first + k);
  return interpolated(points, static_cast<std::size_t>(count), *place);
}

}  // namespace loadpath
