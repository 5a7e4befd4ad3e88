#include "lib/quantity/series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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

/// By sums of products with zero, several at once: NaN and infinities do not vanish.
bool all_finite(const std::vector<double>& si) {
  constexpr std::size_t width = 8;
  std::array<double, width> sums{};
  const double* const x = si.data();
  std::size_t i = 0;
  for (; i + width <= si.size(); i += width) {
    for (std::size_t lane = 0; lane < width; ++lane) sums[lane] += x[i + lane] * 0.0;
  }
  for (; i < si.size(); ++i) sums[0] += x[i] * 0.0;
  return std::all_of(sums.begin(), sums.end(), [](double sum) { return sum == 0.0; });
}

bool available(const Value& series) {
  const Axis* axis = series.signature.axis;
  return !series.si.empty() && (axis == nullptr || axis->at.size() == series.si.size()) && all_finite(series.si);
}

bool over_a_cycle(const Value& series) {
  const Axis* axis = series.signature.axis;
  return axis != nullptr && axis->cyclic() && axis->at.size() == series.si.size() && !series.si.empty();
}

/// The polynomial through five points in Newton's form, seen from one of them: abscissae in steps, values as
/// differences.
class Quartic {
 public:
  Quartic(const std::array<double, 5>& t, const std::array<double, 5>& f) : t_{t}, coefficient_{f} {
    for (std::size_t order = 1; order < 5; ++order) {
      for (std::size_t k = 4; k >= order; --k) {
        coefficient_[k] = (coefficient_[k] - coefficient_[k - 1]) / (t_[k] - t_[k - order]);
      }
      if (order == 2) std::copy(coefficient_.begin() + 2, coefficient_.end(), bend_.begin());
    }
  }

  /// Whether the three parabolas through neighbouring points all open downwards with nearly one curvature. A quarter
  /// keeps the quartic concave between the neighbours of the middle point, hence with one summit and close to the
  /// parabola's; a jump, a kink or fewer than about 13 positions to a wave bend the three further apart.
  [[nodiscard]] bool smooth_summit() const {
    const double allowed = -0.25 * bend_[1];
    return allowed > 0.0 && std::abs(bend_[0] - bend_[1]) <= allowed && std::abs(bend_[2] - bend_[1]) <= allowed;
  }

  struct Local {
    double value = 0.0, slope = 0.0, curvature = 0.0;
  };
  [[nodiscard]] Local operator()(double t) const {
    Local q{coefficient_[4], 0.0, 0.0};
    for (std::size_t k = 4; k-- > 0;) {
      const double step = t - t_[k];
      q.curvature = q.curvature * step + 2.0 * q.slope;
      q.slope = q.slope * step + q.value;
      q.value = q.value * step + coefficient_[k];
    }
    return q;
  }

 private:
  std::array<double, 5> t_;
  std::array<double, 5> coefficient_;
  std::array<double, 3> bend_{};
};

/// Newton's method for the summit between `low` and `high`, from the point at 0.
std::optional<double> summit(const Quartic& quartic, double low, double high) {
  double t = 0.0;
  for (int i = 0; i < 12; ++i) {
    const auto q = quartic(t);
    if (!(q.curvature < 0.0)) return {};
    const double next = std::clamp(t - q.slope / q.curvature, low, high);
    if (std::abs(next - t) < 1e-12) return next;
    t = next;
  }
  return {};
}

/// The place of a summit in the turn that the axis lists. A millionth of a step is below the accuracy of refining:
/// within that distance of the beginning of the axis, or of zero, the place is rounded to it.
double on_axis(const Axis& axis, double at) {
  if (axis.at.size() < 2) return at;
  const double first = axis.at.front(), least = 1e-6 * std::abs(axis.at[1] - first);
  if (std::abs(at - first) <= least) at = first;
  if (axis.cyclic() && (at - first) / axis.period < 0.0) at += axis.period;
  return std::abs(at) <= least ? 0.0 : at;
}

/// Five neighbouring positions around one of them: places in steps from it, and the values.
struct Window {
  std::array<double, 5> t{};
  std::array<double, 5> value{};
  std::size_t own = 0;
  double step = 0.0;
};

Window window_around(const Value& series, std::size_t i) {
  const auto n = static_cast<std::ptrdiff_t>(series.si.size());
  const auto middle = static_cast<std::ptrdiff_t>(i);
  const auto first = series.signature.axis->cyclic() ? middle - 2 : std::clamp<std::ptrdiff_t>(middle - 2, 0, n - 5);
  Window window;
  window.own = static_cast<std::size_t>(middle - first);
  window.step = (point(series, first + 4).at - point(series, first).at) / 4.0;
  for (std::size_t k = 0; k < 5; ++k) {
    const Point p = point(series, first + static_cast<std::ptrdiff_t>(k));
    window.t[k] = (p.at - series.signature.axis->at[i]) / window.step;
    window.value[k] = p.value;
  }
  return window;
}

/// The summit of `height` near the window's own position, and its height above it, if reliable.
std::optional<Point> summit_near(const Window& window, const std::array<double, 5>& height) {
  const Quartic quartic{window.t, height};
  if (!quartic.smooth_summit()) return {};
  const std::size_t own = window.own;
  const auto top = summit(quartic, window.t[own == 0 ? 0 : own - 1], window.t[own == 4 ? 4 : own + 1]);
  if (!top || !(quartic(*top).value > 0.0)) return {};
  return Point{*top, quartic(*top).value};
}

/// The summit of `way` times the series near position i; the position itself if none is reliable. A magnitude has a
/// kink where it passes through zero, its square has none: for non-negative series the valleys are also sought there.
Extreme refined(const Value& series, std::size_t i, double way) {
  const Axis& axis = *series.signature.axis;
  const Extreme sample{series.si[i], on_axis(axis, axis.at[i]), i};
  if (series.si.size() < 5) return sample;
  const Window window = window_around(series, i);
  std::array<double, 5> height{};
  std::transform(window.value.begin(), window.value.end(), height.begin(),
                 [&](double x) { return way * (x - sample.value); });
  if (const auto top = summit_near(window, height)) {
    return {sample.value + way * top->value, on_axis(axis, axis.at[i] + top->at * window.step), i};
  }
  const bool magnitude = std::all_of(window.value.begin(), window.value.end(), [](double x) { return x >= 0.0; });
  if (way > 0.0 || sample.value == 0.0 || !magnitude) return sample;
  std::transform(window.value.begin(), window.value.end(), height.begin(),
                 [&](double x) { return (sample.value - x) * (sample.value + x); });
  const auto top = summit_near(window, height);
  if (!top) return sample;
  const double square = sample.value * sample.value - top->value;
  return {std::sqrt(std::max(square, 0.0)), on_axis(axis, axis.at[i] + top->at * window.step), i};
}

/// Whether `way` times the series is nowhere higher next to its first or last position i.
bool is_summit_at_end(const Value& series, std::size_t i, double way) {
  const std::size_t n = series.si.size();
  const bool cyclic = series.signature.axis->cyclic();
  const double here = way * series.si[i];
  const bool left = (i == 0 && !cyclic) || way * series.si[i == 0 ? n - 1 : i - 1] <= here;
  const bool right = (i == n - 1 && !cyclic) || way * series.si[i == n - 1 ? 0 : i + 1] <= here;
  return left && right;
}

/// Calls visit(i) for the positions between the first and the last one where no neighbour is higher.
template <class IsHigher, class Visit>
void visit_inner_summits(const std::vector<double>& si, IsHigher is_higher, const Visit& visit) {
  const std::size_t last = si.size() - 1;
  for (std::size_t i = 1; i < last; ++i) {
    while (i < last && is_higher(si[i + 1], si[i])) ++i;
    if (i >= last) return;
    if (!is_higher(si[i - 1], si[i])) visit(i);
    while (i + 1 < last && is_higher(si[i], si[i + 1])) ++i;
  }
}

/// Calls visit(i) in the order of the positions.
template <class Visit>
void visit_summits(const Value& series, double way, const Visit& visit) {
  const std::size_t n = series.si.size();
  if (is_summit_at_end(series, 0, way)) visit(0);
  if (way > 0.0)
    visit_inner_summits(series.si, std::greater<>(), visit);
  else
    visit_inner_summits(series.si, std::less<>(), visit);
  if (n > 1 && is_summit_at_end(series, n - 1, way)) visit(n - 1);
}

/// The tolerance for equally high summits: rounding, or its remainder in a solved position.
double tie(const Value& series, double height) { return std::max(series.rounding, 1e-12 * std::abs(height)); }

/// The first of equally high summits; `way` is 1 or -1.
Extreme extreme(const Value& series, double way) {
  if (!available(series)) return {not_available, not_available, 0};
  if (!series.is_series()) return {series.si.front(), 0.0, 0};
  std::optional<Extreme> best;
  visit_summits(series, way, [&](std::size_t i) {
    const Extreme here = refined(series, i, way);
    if (!best || way * (here.value - best->value) > tie(series, best->value))
      best = here;
    else if (way * here.value > way * best->value)
      best->value = here.value;
  });
  return *best;
}

/// The place within the axis: brought into the listed turn of a cycle; nothing outside an open axis.
std::optional<double> place_on(const Axis& axis, double at) {
  const double first = axis.at.front();
  if (axis.cyclic()) {
    const double turns = (at - first) / axis.period;
    return first + (turns - std::floor(turns)) * axis.period;
  }
  const auto [low, high] = std::minmax(first, axis.at.back());
  // The last position is computed, the place is typed: they may differ in the last digits.
  const double slack = 1e-9 * (high - low);
  if (!(at >= low - slack && at <= high + slack)) return {};
  return std::clamp(at, low, high);
}

/// The index of the position at or before a place, in the direction of the axis.
std::ptrdiff_t position_before(const Axis& axis, double at) {
  const bool descending = axis.cyclic() ? axis.period < 0.0 : axis.at.back() < axis.at.front();
  const auto after = std::upper_bound(axis.at.begin(), axis.at.end(), at,
                                      [=](double a, double b) { return descending ? a > b : a < b; });
  return std::max<std::ptrdiff_t>(after - axis.at.begin() - 1, 0);
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

Extreme maximum(const Value& series) { return extreme(series, 1.0); }

// Between positions a curve that touches zero from above may seem to pass it, and is taken as zero.
Extreme minimum(const Value& series) {
  Extreme low = extreme(series, -1.0);
  const bool below = std::any_of(series.si.begin(), series.si.end(), [](double x) { return x < 0.0; });
  if (low.value < 0.0 && !below) low.value = 0.0;
  return low;
}

bool resolves_extremes(const Value& series) {
  constexpr std::size_t fewest = 36;
  constexpr double most_missed = 0.01;
  if (!series.is_series() || !series.signature.axis->cyclic() || !available(series) || is_constant(series)) return true;
  const auto [least, largest] = std::minmax_element(series.si.begin(), series.si.end());
  const double missed = std::max(maximum(series).value - *largest, *least - minimum(series).value);
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

Extreme largest(const Value& series) {
  const Extreme high = maximum(series);
  const Extreme low = minimum(series);
  const double ahead = std::abs(low.value) - std::abs(high.value), alike = tie(series, high.value);
  if (std::abs(ahead) <= alike) {
    const bool low_first = low.nearest < high.nearest;
    return low_first ? low : high;
  }
  return ahead > 0.0 ? low : high;
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
