#include "lib/quantity/expression/interval_functions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loadpath::expression {

namespace {

constexpr double pi_value = std::numbers::pi;

/// Whether a place offset + k step lies between the bounds.
bool passes(const Interval& a, double offset, double step) {
  const double low = (a.low - offset) / step, high = (a.high - offset) / step;
  const double slack = 1e-12 * (1.0 + std::max(std::abs(low), std::abs(high)));
  return std::ceil(low - slack) <= std::floor(high + slack);
}

Interval sine(const Interval& a) {
  constexpr double far = 1e9;  // beyond it the places of the waves are not known well enough
  if (!(a.width() < 2.0 * pi_value) || a.magnitude() > far) return {-1.0, 1.0};
  Interval value = hull({std::sin(a.low), std::sin(a.high)});
  if (passes(a, 0.5 * pi_value, 2.0 * pi_value)) value.high = 1.0;
  if (passes(a, -0.5 * pi_value, 2.0 * pi_value)) value.low = -1.0;
  return {std::max(value.low, -1.0), std::min(value.high, 1.0)};
}

Interval cosine(const Interval& a) {
  constexpr double far = 1e9;
  if (!(a.width() < 2.0 * pi_value) || a.magnitude() > far) return {-1.0, 1.0};
  Interval value = hull({std::cos(a.low), std::cos(a.high)});
  if (passes(a, 0.0, 2.0 * pi_value)) value.high = 1.0;
  if (passes(a, pi_value, 2.0 * pi_value)) value.low = -1.0;
  return {std::max(value.low, -1.0), std::min(value.high, 1.0)};
}

Interval scaled(double factor, const Interval& a) { return Interval{factor, factor} * a; }

/// A square is not negative, as a product of one with itself might be.
Interval square(const Interval& a) { return to_power(a, 2.0); }

IntervalJet chain(const Interval& value, const Interval& first, const Interval& second, const IntervalJet& a) {
  return {value, first * a.first, second * square(a.first) + first * a.second};
}

bool is_still(const IntervalJet& a) { return a.first.magnitude() == 0.0 && a.second.magnitude() == 0.0; }

/// The derivatives of a constant are zero, whatever the function.
IntervalJet chained(const Interval& value, const Interval& first, const Interval& second, const IntervalJet& a) {
  return is_still(a) ? IntervalJet{value, {}, {}} : chain(value, first, second, a);
}

}  // namespace

IntervalJet operator-(const IntervalJet& a) { return {-a.value, -a.first, -a.second}; }
IntervalJet operator+(const IntervalJet& a, const IntervalJet& b) {
  return {a.value + b.value, a.first + b.first, a.second + b.second};
}
IntervalJet operator-(const IntervalJet& a, const IntervalJet& b) { return a + -b; }
IntervalJet operator*(const IntervalJet& a, const IntervalJet& b) {
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + scaled(2.0, a.first * b.first) + a.value * b.second};
}
IntervalJet operator/(const IntervalJet& a, const IntervalJet& b) { return a * pow(b, -1.0); }

IntervalJet pow(const IntervalJet& a, double exponent) {
  const bool ends = exponent == 0.0 || exponent == 1.0;
  const Interval first = exponent == 0.0 ? Interval{} : scaled(exponent, to_power(a.value, exponent - 1.0));
  const Interval second = ends ? Interval{} : scaled(exponent * (exponent - 1.0), to_power(a.value, exponent - 2.0));
  return chained(to_power(a.value, exponent), first, second, a);
}
IntervalJet sqrt(const IntervalJet& a) { return pow(a, 0.5); }
IntervalJet cbrt(const IntervalJet& a) {
  const Interval root = hull({std::cbrt(a.value.low), std::cbrt(a.value.high)});
  return chained(root, scaled(1.0 / 3.0, to_power(root, -2.0)), scaled(-2.0 / 9.0, to_power(root, -5.0)), a);
}
IntervalJet exp(const IntervalJet& a) {
  Interval value = hull({std::exp(a.value.low), std::exp(a.value.high)});
  value.low = std::max(value.low, 0.0);
  return chained(value, value, value, a);
}
IntervalJet log(const IntervalJet& a) {
  const bool has_value = a.value.low > 0.0;
  const Interval value = has_value ? hull({std::log(a.value.low), std::log(a.value.high)}) : Interval::everything();
  const Interval inverse = has_value ? to_power(a.value, -1.0) : Interval::everything();
  return chained(value, inverse, -square(inverse), a);
}
IntervalJet sin(const IntervalJet& a) {
  const Interval value = sine(a.value);
  return chained(value, cosine(a.value), -value, a);
}
IntervalJet cos(const IntervalJet& a) {
  const Interval value = cosine(a.value);
  return chained(value, -sine(a.value), -value, a);
}
IntervalJet tan(const IntervalJet& a) {
  const bool pole =
      !(a.value.width() < pi_value) || a.value.magnitude() > 1e9 || passes(a.value, 0.5 * pi_value, pi_value);
  const Interval value = pole ? Interval::everything() : hull({std::tan(a.value.low), std::tan(a.value.high)});
  const Interval slope = Interval{1.0, 1.0} + square(value);
  return chained(value, slope, scaled(2.0, value * slope), a);
}
IntervalJet atan(const IntervalJet& a) {
  const Interval value = hull({std::atan(a.value.low), std::atan(a.value.high)});
  const Interval slope = to_power(Interval{1.0, 1.0} + square(a.value), -1.0);
  return chained(value, slope, scaled(-2.0, a.value * square(slope)), a);
}

namespace {

/// The derivatives of the arc sine; its own value and that of the arc cosine are monotonic.
IntervalJet arc(const IntervalJet& a, double (*function)(double), double sign) {
  const bool inside = a.value.low >= -1.0 && a.value.high <= 1.0;
  if (!inside) return {Interval::everything(), Interval::everything(), Interval::everything()};
  const Interval rest = Interval{1.0, 1.0} - square(a.value);
  const Interval slope = rest.low > 0.0 ? to_power(rest, -0.5) : Interval::everything();
  const Interval bend = rest.low > 0.0 ? a.value * slope * to_power(rest, -1.0) : Interval::everything();
  return chained(hull({function(a.value.low), function(a.value.high)}), scaled(sign, slope), scaled(sign, bend), a);
}

}  // namespace

IntervalJet asin(const IntervalJet& a) {
  return arc(
      a, [](double x) { return std::asin(x); }, 1.0);
}
IntervalJet acos(const IntervalJet& a) {
  return arc(
      a, [](double x) { return std::acos(x); }, -1.0);
}

IntervalJet atan2(const IntervalJet& y, const IntervalJet& x) {
  const bool leaps = x.value.low <= 0.0 && y.value.holds(0.0);  // crossing the branch cut, or at the origin
  if (leaps) return {{-pi_value, pi_value}, Interval::everything(), Interval::everything()};
  const Interval value = hull({std::atan2(y.value.low, x.value.low), std::atan2(y.value.low, x.value.high),
                               std::atan2(y.value.high, x.value.low), std::atan2(y.value.high, x.value.high)});
  const IntervalJet slope = (IntervalJet{y.first, y.second, {}} * IntervalJet{x.value, x.first, {}} -
                             IntervalJet{x.first, x.second, {}} * IntervalJet{y.value, y.first, {}}) /
                            (IntervalJet{square(x.value), scaled(2.0, x.value * x.first), {}} +
                             IntervalJet{square(y.value), scaled(2.0, y.value * y.first), {}});
  return {value, slope.value, slope.first};
}

}  // namespace loadpath::expression
