#include "calculators/column/member/stability.hpp"

#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <array>
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

/// The symmetric stiffness of all nodes, deflection and angle in turn; a band of four next to the diagonal.
template <std::size_t nodes>
struct Stiffness {
  static constexpr std::size_t most = 2 * nodes, band = 4;
  std::array<std::array<double, band>, most> rows{};  // rows[i][k] = K(i, i + k)
  std::size_t size = 0;

  void add(std::size_t i, std::size_t j, double k) { rows[std::min(i, j)][std::max(i, j) - std::min(i, j)] += k; }

  void add_span(std::size_t node, const Span& s) {
    const std::size_t v = 2 * node, t = v + 1, v2 = v + 2, t2 = v + 3;
    add(v, v, s.shear), add(v2, v2, s.shear), add(v, v2, -s.shear);
    add(t, t, s.near), add(t2, t2, s.near), add(t, t2, s.far);
    add(v, t, s.cross), add(v, t2, s.cross), add(t, v2, -s.cross), add(v2, t2, -s.cross);
  }

  /// Fixed degrees of freedom are removed: row and column are cleared, the pivot is 1.
  void hold(std::size_t i) {
    for (std::size_t k = 0; k < band; ++k) {
      rows[i][k] = 0.0;
      if (k <= i) rows[i - k][k] = 0.0;
    }
    rows[i][0] = 1.0;
  }

  void support(std::size_t i, double spring) {
    if (std::isinf(spring)) {
      hold(i);
    } else {
      rows[i][0] += spring;
    }
  }

  /// Triangular factors in place; how many pivots are negative.
  int factor() {
    int negative = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const double pivot = rows[i][0] == 0.0 ? 1e-300 : rows[i][0];
      negative += pivot < 0.0 ? 1 : 0;
      for (std::size_t j = 1; j < band && i + j < size; ++j) {
        const double ratio = rows[i][j] / pivot;
        for (std::size_t k = j; k < band && i + k < size; ++k) rows[i + j][k - j] -= ratio * rows[i][k];
        rows[i][j] = ratio;
      }
      rows[i][0] = pivot;
    }
    return negative;
  }

  void solve(std::vector<double>& b) const {
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t k = 1; k < band && i + k < size; ++k) b[i + k] -= rows[i][k] * b[i];
    }
    for (std::size_t i = size; i-- > 0;) {
      b[i] /= rows[i][0];
      for (std::size_t k = 1; k < band && i + k < size; ++k) b[i] -= rows[i][k] * b[i + k];
    }
  }
};

void add_ends(auto& stiffness, const Bar& bar, std::size_t last) {
  stiffness.support(0, bar.start.across);
  stiffness.support(1, bar.start.turning);
  stiffness.support(2 * last, bar.end.across);
  stiffness.support(2 * last + 1, bar.end.turning);
}

/// The number of critical forces below u.
int criticals_below(const Bar& bar, double u) {
  Stiffness<most_supports + 2> stiffness;
  const std::size_t last = bar.supports.size() + 1;
  stiffness.size = 2 * (last + 1);
  int count = 0;
  double x = 0.0;
  for (std::size_t node = 0; node < last; ++node) {
    const double next = node + 1 < last ? bar.supports[node] : 1.0;
    const Span span = span_at(u, next - x);
    stiffness.add_span(node, span);
    count += span.clamped;
    x = next;
  }
  for (std::size_t node = 1; node < last; ++node) stiffness.hold(2 * node);
  add_ends(stiffness, bar, last);
  return count + stiffness.factor();
}

/// Whether no motion of the rigid bar is free.
bool is_held(const Bar& bar) {
  const auto across = [](const End& end) { return end.across > 0.0 ? 1U : 0U; };
  const std::size_t places = across(bar.start) + across(bar.end) + bar.supports.size();
  return places > 1 || (places == 1 && (bar.start.turning > 0.0 || bar.end.turning > 0.0));
}

constexpr double least_parameter = 1e-3;  // below: an effective length of more than 3000 l is a mechanism

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

double buckling_parameter(const Bar& bar) {
  if (!is_held(bar)) return std::numeric_limits<double>::quiet_NaN();
  double low = 1.0, high = 1.0;
  while (criticals_below(bar, high) == 0) high *= 2.0;
  while (low > least_parameter && criticals_below(bar, low) > 0) low *= 0.5;
  if (low <= least_parameter) return std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (criticals_below(bar, middle) == 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Inverse iteration just below the critical force, where the stiffness is nearly singular only in the mode.
Shape buckled_shape(const Bar& bar, double u) {
  constexpr std::size_t most_nodes = 7 * (most_supports + 1) + 1;
  Shape shape{stations(bar), {}};
  Stiffness<std::max(most_nodes, parts + 1)> stiffness;
  const std::size_t last = shape.x.size() - 1;
  stiffness.size = 2 * (last + 1);
  for (std::size_t node = 0; node < last; ++node)
    stiffness.add_span(node, span_at(u * (1.0 - 1e-7), shape.x[node + 1] - shape.x[node]));
  for (std::size_t node = 1; node < last; ++node) {
    if (std::find(bar.supports.begin(), bar.supports.end(), shape.x[node]) != bar.supports.end())
      stiffness.hold(2 * node);
  }
  add_ends(stiffness, bar, last);
  stiffness.factor();
  std::vector<double> mode(stiffness.size);
  for (std::size_t i = 0; i < mode.size(); ++i)
    mode[i] = 1.0 + 0.01 * static_cast<double>(i);  // no mode is at right angles
  for (int round = 0; round < 3; ++round) {
    stiffness.solve(mode);
    const double size = std::abs(
        *std::max_element(mode.begin(), mode.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
    for (double& w : mode) w /= size;
  }
  double largest = 0.0;
  for (std::size_t node = 0; node <= last; ++node) {
    shape.w.push_back(mode[2 * node]);
    if (numerics::exceeds(std::abs(mode[2 * node]), std::abs(largest))) largest = mode[2 * node];
  }
  for (double& w : shape.w) w /= largest;
  return shape;
}

}  // namespace loadpath::column
