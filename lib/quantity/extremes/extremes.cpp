#include "lib/quantity/extremes/extremes.hpp"

#include "lib/simd/attributes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace loadpath {
namespace {

constexpr double no_extreme = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t scan_lanes = 8;

struct Summit {
  double at = 0.0;
  double value = 0.0;
};

/// The least and the greatest value.
struct Spread {
  double low = infinite, high = -infinite;
  bool is_finite = false;  // all values are
};

/// In lanes; sums of products with zero show NaN and infinities, which do not vanish.
LOADPATH_COLUMNS Spread spread_of(std::span<const double> si) {
  std::array<double, scan_lanes> low, high, sum;
  low.fill(infinite);
  high.fill(-infinite);
  sum.fill(0.0);
  const double* const x = si.data();
  std::size_t i = 0;
  for (; i + scan_lanes <= si.size(); i += scan_lanes) {
    LOADPATH_LANEWISE
    for (std::size_t lane = 0; lane < scan_lanes; ++lane) {
      low[lane] = x[i + lane] < low[lane] ? x[i + lane] : low[lane];
      high[lane] = x[i + lane] > high[lane] ? x[i + lane] : high[lane];
      sum[lane] += x[i + lane] * 0.0;
    }
  }
  for (; i < si.size(); ++i) {
    low[0] = x[i] < low[0] ? x[i] : low[0];
    high[0] = x[i] > high[0] ? x[i] : high[0];
    sum[0] += x[i] * 0.0;
  }
  double total = 0.0;
  for (const double part : sum) total += part;
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end()), total == 0.0};
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

/// The place of the position `k`, counted on through neighbouring turns of a cycle, and its index.
struct AxisPlace {
  double at = 0.0;
  std::size_t index = 0;
};
AxisPlace axis_place(const Axis& axis, std::ptrdiff_t k) {
  const auto n = static_cast<std::ptrdiff_t>(axis.at.size());
  if (k >= 0 && k < n) return {axis.at[static_cast<std::size_t>(k)], static_cast<std::size_t>(k)};
  const std::ptrdiff_t turn = k >= 0 ? k / n : (k + 1) / n - 1;
  const auto i = static_cast<std::size_t>(k - turn * n);
  return {axis.at[i] + static_cast<double>(turn) * axis.period, i};
}

Window window_around(const SeriesView& series, std::size_t i) {
  const auto n = static_cast<std::ptrdiff_t>(series.si.size());
  const auto middle = static_cast<std::ptrdiff_t>(i);
  const auto first = series.axis->cyclic() ? middle - 2 : std::clamp<std::ptrdiff_t>(middle - 2, 0, n - 5);
  Window window;
  window.own = static_cast<std::size_t>(middle - first);
  window.step = (axis_place(*series.axis, first + 4).at - axis_place(*series.axis, first).at) / 4.0;
  for (std::size_t k = 0; k < 5; ++k) {
    const AxisPlace place = axis_place(*series.axis, first + static_cast<std::ptrdiff_t>(k));
    window.t[k] = (place.at - series.axis->at[i]) / window.step;
    window.value[k] = series.si[place.index];
  }
  return window;
}

/// The summit of `height` near the window's own position, and its height above it, if reliable.
std::optional<Summit> summit_near(const Window& window, const std::array<double, 5>& height) {
  const Quartic quartic{window.t, height};
  if (!quartic.smooth_summit()) return {};
  const std::size_t own = window.own;
  const auto top = summit(quartic, window.t[own == 0 ? 0 : own - 1], window.t[own == 4 ? 4 : own + 1]);
  if (!top || !(quartic(*top).value > 0.0)) return {};
  return Summit{*top, quartic(*top).value};
}

/// The summit of `way` times the series near position i; the position itself if none is reliable. A magnitude has a
/// kink where it passes through zero, its square has none: for non-negative series the valleys are also sought there.
Extreme refined(const SeriesView& series, std::size_t i, double way) {
  const Axis& axis = *series.axis;
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

/// Not less than the height of a refined summit above its position i. Between even positions the quartic of a smooth
/// summit rises by less than half of its second difference, and the square of a magnitude likewise.
double most_rise(const SeriesView& series, std::size_t i) {
  constexpr double rounding = 1e-6;  // of a step
  const std::size_t n = series.si.size();
  const bool has_neighbours = n >= 5 && (series.axis->cyclic() || (i >= 2 && i + 2 < n));
  if (!has_neighbours) return infinite;
  const auto middle = static_cast<std::ptrdiff_t>(i);
  const double at = series.axis->at[i];
  const AxisPlace before = axis_place(*series.axis, middle - 1), after = axis_place(*series.axis, middle + 1);
  const double step = after.at - at;
  const auto is_even = [&](double distance, double steps) {
    return std::abs(distance - steps * step) <= rounding * std::abs(step);
  };
  const bool all_even = is_even(at - before.at, 1.0) && is_even(at - axis_place(*series.axis, middle - 2).at, 2.0) &&
                        is_even(axis_place(*series.axis, middle + 2).at - at, 2.0);
  const double here = series.si[i];
  return all_even ? 2.0 * std::max(std::abs(series.si[before.index] - here), std::abs(series.si[after.index] - here))
                  : infinite;
}

/// Whether `way` times the series is nowhere higher next to its first or last position i.
bool is_summit_at_end(const SeriesView& series, std::size_t i, double way) {
  const std::size_t n = series.si.size();
  const bool cyclic = series.axis->cyclic();
  const double here = way * series.si[i];
  const bool left = (i == 0 && !cyclic) || way * series.si[i == 0 ? n - 1 : i - 1] <= here;
  const bool right = (i == n - 1 && !cyclic) || way * series.si[i == n - 1 ? 0 : i + 1] <= here;
  return left && right;
}

bool is_inner_summit(std::span<const double> si, std::size_t i, double way) {
  return way * si[i - 1] <= way * si[i] && way * si[i + 1] <= way * si[i];
}

constexpr std::size_t stretch = 4 * scan_lanes;

/// The next position from i on that begins a stretch with a summit; or one of the last stretch.
LOADPATH_COLUMNS std::size_t next_stretch_with_summit(std::span<const double> si, std::size_t i, double way) {
  for (; i + stretch < si.size(); i += stretch) {
    std::array<double, scan_lanes> count{};
    for (std::size_t first = i; first < i + stretch; first += scan_lanes) {
      const double* const x = si.data() + first;
      LOADPATH_LANEWISE
      for (std::size_t lane = 0; lane < scan_lanes; ++lane) {
        const double here = way * x[lane], before = way * x[static_cast<std::ptrdiff_t>(lane) - 1];
        const double neighbour = before > way * x[lane + 1] ? before : way * x[lane + 1];
        count[lane] += neighbour <= here ? 1.0 : 0.0;
      }
    }
    double all = 0.0;
    for (const double one : count) all += one;
    if (all > 0.0) break;
  }
  return i;
}

/// Calls visit(i) for the positions between the first and the last one where no neighbour is higher.
template <class Visit>
void visit_inner_summits(std::span<const double> si, double way, const Visit& visit) {
  const std::size_t last = si.size() - 1;
  for (std::size_t i = 1; i < last;) {
    i = next_stretch_with_summit(si, i, way);
    for (const std::size_t end = std::min(i + stretch, last); i < end; ++i) {
      if (is_inner_summit(si, i, way)) visit(i);
    }
  }
}

/// Calls visit(i) in the order of the positions.
template <class Visit>
void visit_summits(const SeriesView& series, double way, const Visit& visit) {
  const std::size_t n = series.si.size();
  if (is_summit_at_end(series, 0, way)) visit(0);
  visit_inner_summits(series.si, way, visit);
  if (n > 1 && is_summit_at_end(series, n - 1, way)) visit(n - 1);
}

/// The tolerance for equally high summits: rounding, or its remainder in a solved position.
double tie(const SeriesView& series, double height) { return std::max(series.rounding, 1e-12 * std::abs(height)); }

bool is_available(const SeriesView& series) {
  return !series.si.empty() && (series.axis == nullptr || series.axis->at.size() == series.si.size());
}

/// The first of equally high summits; `way` is 1 or -1. A summit that may neither be the highest nor raise it in steps
/// of their tolerance is not refined.
Extreme extreme(const SeriesView& series, const Spread& spread, double way) {
  if (!spread.is_finite) return {no_extreme, no_extreme, 0};
  if (series.axis == nullptr) return {series.si.front(), 0.0, 0};
  const double top = way > 0.0 ? spread.high : -spread.low;
  const double steps = 4.0 * static_cast<double>(series.si.size());
  const double level = top - steps * tie(series, std::max(std::abs(spread.low), std::abs(spread.high)));
  std::optional<Extreme> best;
  visit_summits(series, way, [&](std::size_t i) {
    if (way * series.si[i] + most_rise(series, i) < level) return;
    const Extreme here = refined(series, i, way);
    if (!best || way * (here.value - best->value) > tie(series, best->value))
      best = here;
    else if (way * here.value > way * best->value)
      best->value = here.value;
  });
  return *best;
}

// Between positions a curve that touches zero from above may seem to pass it, and is taken as zero.
Extreme lowest(const SeriesView& series, const Spread& spread) {
  Extreme low = extreme(series, spread, -1.0);
  if (low.value < 0.0 && !(spread.low < 0.0)) low.value = 0.0;
  return low;
}

Spread checked_spread(const SeriesView& series) { return is_available(series) ? spread_of(series.si) : Spread{}; }

SeriesView view_of(const Value& series) { return {series.si, series.signature.axis, series.rounding}; }

}  // namespace

Extreme maximum(const SeriesView& series) { return extreme(series, checked_spread(series), 1.0); }
Extreme minimum(const SeriesView& series) { return lowest(series, checked_spread(series)); }

Extreme largest(const SeriesView& series) {
  const Spread spread = checked_spread(series);
  const Extreme high = extreme(series, spread, 1.0);
  const double alike = tie(series, high.value);
  if (spread.low >= 0.0 && spread.low < high.value - alike) return high;  // then the least is between zero and `low`
  const Extreme low = lowest(series, spread);
  const double ahead = std::abs(low.value) - std::abs(high.value);
  if (std::abs(ahead) <= alike) {
    const bool low_first = low.nearest < high.nearest;
    return low_first ? low : high;
  }
  return ahead > 0.0 ? low : high;
}

Extreme maximum(const Value& series) { return maximum(view_of(series)); }
Extreme minimum(const Value& series) { return minimum(view_of(series)); }
Extreme largest(const Value& series) { return largest(view_of(series)); }

}  // namespace loadpath
