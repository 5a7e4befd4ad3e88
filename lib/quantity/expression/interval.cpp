#include "lib/quantity/expression/interval.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath {

Interval outward(double low, double high) {
  if (std::isnan(low) || std::isnan(high)) return Interval::everything();
  const auto beyond = [](double x, double way) { return x + way * (4e-16 * std::abs(x) + 1e-300); };
  return {beyond(low, -1.0), beyond(high, 1.0)};
}

Interval hull(std::initializer_list<double> values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const bool known = std::none_of(values.begin(), values.end(), [](double x) { return std::isnan(x); });
  return known ? outward(*low, *high) : Interval::everything();
}

Interval to_power(const Interval& a, double exponent) {
  if (exponent == 0.0) return {1.0, 1.0};
  if (exponent == 1.0) return a;
  const bool whole = exponent == std::round(exponent);
  if (a.low > 0.0) return hull({std::pow(a.low, exponent), std::pow(a.high, exponent)});
  if (exponent < 0.0) {
    if (!whole || a.high >= 0.0) return Interval::everything();
    return hull({std::pow(a.low, exponent), std::pow(a.high, exponent)});
  }
  if (!whole && a.low < 0.0) return Interval::everything();
  const double low = std::pow(a.low, exponent), high = std::pow(a.high, exponent);
  const bool even = whole && std::fmod(exponent, 2.0) == 0.0;
  Interval value = hull({low, high});
  if (even && a.holds(0.0)) value.low = 0.0;
  if (even) value.low = std::max(value.low, 0.0);
  return value;
}

bool Interval::is_bounded() const { return std::isfinite(low) && std::isfinite(high); }

Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
Interval operator+(const Interval& a, const Interval& b) { return outward(a.low + b.low, a.high + b.high); }
Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
Interval operator*(const Interval& a, const Interval& b) {
  if ((a.low == 0.0 && a.high == 0.0) || (b.low == 0.0 && b.high == 0.0)) return {};
  const auto product = [](double x, double y) { return x == 0.0 || y == 0.0 ? 0.0 : x * y; };
  return hull({product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high)});
}
Interval operator/(const Interval& a, const Interval& b) { return a * to_power(b, -1.0); }

Interval both(const Interval& a, const Interval& b) {
  const Interval common{std::max(a.low, b.low), std::min(a.high, b.high)};
  return common.low <= common.high ? common : a;
}
Interval joined(const Interval& a, const Interval& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

}  // namespace loadpath
