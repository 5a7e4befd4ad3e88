#include "lib/sweep/sensitivity/slopes.hpp"

#include "lib/sweep/column_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loadpath::sweep {

namespace {

constexpr std::size_t levels = 10;  // the finest step is a 512th of the first
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding = std::numeric_limits<double>::epsilon();

struct Estimate {
  double value = none, error = none;
  double finest = none;  // the difference over the smallest step
  [[nodiscard]] bool is_there() const { return !std::isnan(value); }
};

/// An output at the base and at steps from it.
struct Samples {
  double at = 0.0, base = none, step = 0.0;
  std::array<double, levels> below{}, above{};

  [[nodiscard]] double size(std::size_t level) const { return std::ldexp(step, -static_cast<int>(level)); }
  /// The largest slope of a chord from the base.
  [[nodiscard]] double steepest() const;
  /// The contribution of rounding in the output and the input to a difference over the first step.
  [[nodiscard]] double noise() const { return 2.0 * rounding * (std::abs(base) + std::abs(at) * steepest()) / step; }
};

double Samples::steepest() const {
  double most = 0.0;
  for (std::size_t m = 0; m < levels; ++m) {
    for (const double value : {below[m], above[m]}) {
      if (std::isfinite(value)) most = std::max(most, std::abs(value - base) / size(m));
    }
  }
  return most;
}

/// The limit of differences whose error is a series in powers of step^order; those that are not finite are skipped.
Estimate extrapolated(const std::array<double, levels>& differences, double ratio, double noise) {
  Estimate best;
  std::array<double, levels> row{};
  std::size_t known = 0;
  for (const double difference : differences) {
    const double rounded = noise;
    noise *= 2.0;  // over half the step
    if (!std::isfinite(difference)) {
      known = 0;
      continue;
    }
    best.finest = difference;
    auto last = row;
    row[0] = difference;
    double factor = 1.0;
    for (std::size_t k = 1; k <= known; ++k) {
      factor *= ratio;
      row[k] = row[k - 1] + (row[k - 1] - last[k - 1]) / (factor - 1.0);
      const double error = std::max({std::abs(row[k] - row[k - 1]), std::abs(row[k] - last[k - 1]), rounded});
      if (!best.is_there() || error < best.error) best.value = row[k], best.error = error;
    }
    ++known;
  }
  return best;
}

Estimate from_both(const Samples& f) {
  std::array<double, levels> differences{};
  for (std::size_t m = 0; m < levels; ++m) differences[m] = (f.above[m] - f.below[m]) / (2.0 * f.size(m));
  return extrapolated(differences, 4.0, f.noise());
}

Estimate from_one(const Samples& f, const std::array<double, levels>& side, double direction) {
  std::array<double, levels> differences{};
  for (std::size_t m = 0; m < levels; ++m) differences[m] = (side[m] - f.base) / (direction * f.size(m));
  return extrapolated(differences, 2.0, f.noise());
}

/// Whether an estimate is sure to a thousandth of the largest chord from the base, or to noise, and the finest
/// difference agrees with it to a hundredth.
bool is_settled(const Samples& f, const Estimate& estimate) {
  double change = 0.0;
  for (std::size_t m = 0; m < levels; ++m) {
    for (const double value : {f.below[m], f.above[m]}) {
      if (std::isfinite(value)) change = std::max(change, std::abs(value - f.base));
    }
  }
  const double chord = change / f.step, noise = std::ldexp(f.noise(), levels);
  return estimate.error <= 1e-3 * chord + noise && std::abs(estimate.finest - estimate.value) <= 1e-2 * chord + noise;
}

bool differ(const Estimate& below, const Estimate& above) {
  const double apart = std::abs(above.value - below.value);
  return apart > 10.0 * (below.error + above.error) + 1e-6 * std::max(std::abs(below.value), std::abs(above.value));
}

Slope slope_of(const Samples& f) {
  using Kind = Slope::Kind;
  Slope slope{Kind::none, none, none, none, none, none};
  if (!std::isfinite(f.base)) return slope;
  const Estimate below = from_one(f, f.below, -1.0), above = from_one(f, f.above, 1.0), both = from_both(f);
  if (!below.is_there() && !above.is_there()) return slope;
  slope.below = below.value, slope.above = above.value;
  Estimate best = both;
  slope.kind = Kind::smooth;
  if (!both.is_there() || !below.is_there() || !above.is_there()) {
    best = above.is_there() ? above : below;
    slope.kind = above.is_there() ? Kind::above : Kind::below;
  } else if (differ(below, above)) {
    best.value = 0.5 * (below.value + above.value), best.error = 0.5 * std::abs(above.value - below.value);
    slope.kind = Kind::kink;
  }
  slope.value = best.value, slope.error = best.error;
  const bool settled = (!below.is_there() || is_settled(f, below)) && (!above.is_there() || is_settled(f, above)) &&
                       (slope.kind != Kind::smooth || is_settled(f, both));
  if (!settled) slope.kind = Kind::unsettled;
  return slope;
}

double step_at(double x, double wanted) {
  if (wanted > 0.0) return wanted;
  return x == 0.0 ? 0.01 : 0.01 * std::abs(x);
}

/// A step so that x and x + step differ by it exactly.
double exact_step(double x, double step) {
  const volatile double there = x + step;
  return there - x;
}

}  // namespace

Slopes slopes(Function& function, const std::vector<double>& base, std::span<const double> steps) {
  const std::size_t k = base.size(), n = 1 + 2 * levels * k;
  Columns in(k, n), out(function.outputs(), n);
  std::vector<double> first(k);
  for (std::size_t i = 0; i < k; ++i) {
    first[i] = exact_step(base[i], step_at(base[i], steps.empty() ? 0.0 : steps[i]));
    std::fill_n(in[i], n, base[i]);
    double* const at = in[i] + 1 + 2 * levels * i;
    for (std::size_t m = 0; m < levels; ++m) {
      const double h = std::ldexp(first[i], -static_cast<int>(m));
      at[2 * m] = base[i] - h, at[2 * m + 1] = base[i] + h;
    }
  }
  function.evaluate(in.read(), out.write(), n);
  Slopes all;
  all.inputs = k;
  for (std::size_t o = 0; o < function.outputs(); ++o) {
    all.base.push_back(out[o][0]);
    for (std::size_t i = 0; i < k; ++i) {
      Samples f{base[i], out[o][0], first[i], {}, {}};
      const double* const values = out[o] + 1 + 2 * levels * i;
      for (std::size_t m = 0; m < levels; ++m) f.below[m] = values[2 * m], f.above[m] = values[2 * m + 1];
      all.slopes.push_back(slope_of(f));
      all.slopes.back().elasticity = f.base == 0.0 ? none : all.slopes.back().value * base[i] / f.base;
    }
  }
  return all;
}

}  // namespace loadpath::sweep
