#include "calculators/column/member/stability.hpp"

#include "calculators/column/member/stiffness.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loadpath::column {

namespace {

using std::numbers::pi;

/// Stiffnesses of a span of length a (of l) in E I/l and its powers; h is half of its own parameter, w = u a.
struct Span {
  double near, far, cross, shear;  // moment at the turned end, at the other; by a deflection; force by a deflection
  int clamped;                     // critical forces below u of the span with both ends held
};

/// 1 - h cot h without the cancellation of small h.
double one_less_cotangent(double h) {
  if (h > 0.25) return 1.0 - h / std::tan(h);
  const double s = h * h;
  return s / 3.0 * (1.0 + s / 15.0 * (1.0 + s * 2.0 / 21.0 * (1.0 + s / 10.0 * (1.0 + s * 10.0 / 99.0))));
}

/// How many critical forces of the clamped span lie below: symmetric ones at h = m pi, others where tan h = h.
int clamped_below(double h, double cotangent) {
  const int m = static_cast<int>(std::floor(h / pi));
  return m < 1 ? 0 : 2 * m - 1 + (cotangent < 1.0 ? 1 : 0);
}

Span span_at(double u, double a) {
  const double h = 0.5 * u * a;
  const double less = one_less_cotangent(h), f1 = 1.0 - less, f2 = h * h / (3.0 * less);
  return {(3.0 * f2 + f1) / a, (3.0 * f2 - f1) / a, 6.0 * f2 / (a * a), 12.0 * f1 * f2 / (a * a * a),
          clamped_below(h, f1)};
}

/// Adds a span between a node and the next.
void add_span(auto& stiffness, std::size_t node, const Span& s) {
  const std::size_t v = 2 * node, t = v + 1, v2 = v + 2, t2 = v + 3;
  stiffness.add(v, v, s.shear), stiffness.add(v2, v2, s.shear), stiffness.add(v, v2, -s.shear);
  stiffness.add(t, t, s.near), stiffness.add(t2, t2, s.near), stiffness.add(t, t2, s.far);
  stiffness.add(v, t, s.cross), stiffness.add(v, t2, s.cross);
  stiffness.add(t, v2, -s.cross), stiffness.add(v2, t2, -s.cross);
}

/// The number of critical forces below u. Each span is cut into `pieces`: two, of which none is critical between clamps
/// where the span is, as the span itself is in its higher modes between hinges.
template <std::size_t pieces>
int criticals_below(const Bar& bar, double u) {
  constexpr double cut = 0.3819660112501051;  // the golden section, no ratio of small numbers
  BandStiffness<pieces*(most_supports + 1) + 1> stiffness;
  const std::size_t last = pieces * (bar.supports.size() + 1);
  stiffness.size = 2 * (last + 1);
  int count = 0;
  const auto add = [&](std::size_t node, double length) {
    const Span span = span_at(u, length);
    add_span(stiffness, node, span);
    count += span.clamped;
  };
  double x = 0.0;
  for (std::size_t node = 0; node < last; node += pieces) {
    const double next = node + pieces < last ? bar.supports[node / pieces] : 1.0;
    const double first = pieces > 1 ? cut * (next - x) : next - x;
    add(node, first);
    if constexpr (pieces > 1) add(node + 1, next - x - first);
    x = next;
  }
  for (std::size_t node = pieces; node < last; node += pieces) stiffness.hold(2 * node);
  add_ends(stiffness, bar.start, bar.end, last);
  return count + stiffness.factor();
}

constexpr double least_parameter = 1e-3;  // below: an effective length of more than 3000 l is a mechanism

/// Bisection for the critical force of this number.
template <std::size_t pieces>
double parameter_of(const Bar& bar, int mode) {
  double low = 1.0, high = 1.0;
  while (criticals_below<pieces>(bar, high) < mode) high *= 2.0;
  while (low > least_parameter && criticals_below<pieces>(bar, low) >= mode) low *= 0.5;
  if (low <= least_parameter) return std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (criticals_below<pieces>(bar, middle) < mode ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Whether no motion of the rigid bar is free.
bool is_held(const Bar& bar) {
  const auto across = [](const End& end) { return end.across > 0.0 ? 1U : 0U; };
  const std::size_t places = across(bar.start) + across(bar.end) + bar.supports.size();
  return places > 1 || (places == 1 && (bar.start.turning > 0.0 || bar.end.turning > 0.0));
}

constexpr std::size_t parts = 48;  // elements of a bar in one span; at least 6 in each

/// The points of the mode shape: every span in equal parts.
std::vector<double> stations(const Bar& bar) {
  const std::size_t each = std::max<std::size_t>(6, parts / (bar.supports.size() + 1));
  std::vector<double> x{0.0};
  for (std::size_t span = 0; span <= bar.supports.size(); ++span) {
    const double from = x.back(), to = span < bar.supports.size() ? bar.supports[span] : 1.0;
    for (std::size_t i = 1; i < each; ++i)
      x.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(each));
    x.push_back(to);
  }
  return x;
}

}  // namespace

double buckling_parameter(const Bar& bar, int mode) {
  if (!is_held(bar)) return std::numeric_limits<double>::quiet_NaN();
  return mode == 1 ? parameter_of<1>(bar, mode) : parameter_of<2>(bar, mode);
}

/// Inverse iteration just below the critical force, where the stiffness is nearly singular only in the mode.
Shape buckled_shape(const Bar& bar, double u) {
  constexpr std::size_t most_nodes = 7 * (most_supports + 1) + 1;
  Shape shape{stations(bar), {}};
  BandStiffness<std::max(most_nodes, parts + 1)> stiffness;
  const std::size_t last = shape.x.size() - 1;
  stiffness.size = 2 * (last + 1);
  for (std::size_t node = 0; node < last; ++node)
    add_span(stiffness, node, span_at(u * (1.0 - 1e-7), shape.x[node + 1] - shape.x[node]));
  for (std::size_t node = 1; node < last; ++node) {
    if (std::find(bar.supports.begin(), bar.supports.end(), shape.x[node]) != bar.supports.end())
      stiffness.hold(2 * node);
  }
  add_ends(stiffness, bar.start, bar.end, last);
  stiffness.factor();
  const std::vector<double> mode = mode_of(stiffness);
  double largest = 0.0;
  for (std::size_t node = 0; node <= last; ++node) {
    shape.w.push_back(mode[2 * node]);
    if (numerics::exceeds(std::abs(mode[2 * node]), std::abs(largest))) largest = mode[2 * node];
  }
  for (double& w : shape.w) w /= largest;
  return shape;
}

}  // namespace loadpath::column
