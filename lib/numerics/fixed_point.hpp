// Fixed points of functions of one variable.
#pragma once

#include <cmath>
#include <limits>

namespace loadpath::numerics {

namespace detail {

/// A place and the value of a function there.
struct Known {
  double x, f;
};

/// The zero of a function between low and high, where its signs differ, to rounding: regula falsi by the Illinois rule.
/// NaN if it does not settle.
template <class Function>
Known sign_change(const Function& f, Known low, Known high) {
  double last = std::abs(high.x - low.x);
  for (int i = 0; i < 100 && high.f != 0.0; ++i) {
    const double x = high.x - high.f * (high.x - low.x) / (high.f - low.f);
    const Known next = f(x);
    const bool same_side = (next.f > 0.0) == (high.f > 0.0);
    if (same_side) {
      low.f *= 0.5;
    } else {
      low = high;
    }
    const double step = std::abs(x - high.x), size = std::abs(x);
    const bool settled = step <= 4e-16 * size || (step <= 1e-13 * size && step >= 0.25 * last);
    last = step;
    high = next;
    if (settled) return high;
  }
  return high.f == 0.0 ? high : Known{std::numeric_limits<double>::quiet_NaN(), high.f};
}

}  // namespace detail

/// The x in [0, most] with g(x) = x, to rounding, of a g >= 0 that is above x up to there and below it beyond; 0 if
/// g(0) is 0, NaN if there is none. A constant takes two calls, a straight line three.
template <class Function>
double fixed_point(const Function& g, double most) {
  using detail::Known;
  const auto excess = [&](double x) { return Known{x, g(x) - x}; };
  const auto settled = [](const Known& known) { return std::abs(known.f) <= 4e-16 * known.x; };
  const Known none = excess(0.0);
  if (!(none.f <= most)) return std::numeric_limits<double>::quiet_NaN();
  Known low = none, high = excess(none.f);
  if (settled(high)) return high.x;
  const double straight = high.f < none.f ? none.f * high.x / (none.f - high.f) : most;
  high = excess(std::fmin(straight, most));
  while (!settled(high) && high.f > 0.0 && high.x < most) {
    low = high;
    high = excess(std::fmin(2.0 * high.x, most));
  }
  if (settled(high)) return high.x;
  return high.f <= 0.0 ? detail::sign_change(excess, low, high).x : std::numeric_limits<double>::quiet_NaN();
}

/// The same of a straight line g, by two calls and without a branch; NaN if it does not meet x in [0, most].
template <class Function>
double straight_fixed_point(const Function& g, double most) {
  const double none = g(0.0), rise = g(none) - none;
  const double x = none == 0.0 ? 0.0 : none / (1.0 - rise / none);
  return x >= 0.0 && x <= most ? x : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace loadpath::numerics
