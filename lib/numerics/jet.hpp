// Numbers with their first and second derivative with respect to one variable: exact to rounding, no differences.
#pragma once

#include <cmath>

namespace loadpath::numerics {

struct Jet {
  double value = 0.0, first = 0.0, second = 0.0;

  /// The chain rule for a function with this value and these derivatives at a.
  static constexpr Jet chain(double value, double first, double second, const Jet& a) {
    return {value, first * a.first, second * a.first * a.first + first * a.second};
  }
};

constexpr Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.first + b.first, a.second + b.second};
}
constexpr Jet operator-(const Jet& a) { return {-a.value, -a.first, -a.second}; }
constexpr Jet operator-(const Jet& a, const Jet& b) { return a + -b; }
constexpr Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + 2.0 * a.first * b.first + a.value * b.second};
}
constexpr Jet reciprocal(const Jet& a) {
  const double inverse = 1.0 / a.value;
  return Jet::chain(inverse, -inverse * inverse, 2.0 * inverse * inverse * inverse, a);
}
constexpr Jet operator/(const Jet& a, const Jet& b) { return a * reciprocal(b); }

/// A constant power. An integer power of zero is smooth: its derivatives vanish instead of growing.
inline Jet pow(const Jet& a, double exponent) {
  const double first = exponent == 0.0 ? 0.0 : exponent * std::pow(a.value, exponent - 1.0);
  const bool ends = exponent == 0.0 || exponent == 1.0;
  const double second = ends ? 0.0 : exponent * (exponent - 1.0) * std::pow(a.value, exponent - 2.0);
  return Jet::chain(std::pow(a.value, exponent), first, second, a);
}
inline Jet sqrt(const Jet& a) { return pow(a, 0.5); }
inline Jet cbrt(const Jet& a) {
  const double root = std::cbrt(a.value), square = root * root;
  return Jet::chain(root, 1.0 / (3.0 * square), -2.0 / (9.0 * square * square * root), a);
}
inline Jet exp(const Jet& a) {
  const double value = std::exp(a.value);
  return Jet::chain(value, value, value, a);
}
/// To the base e.
inline Jet log(const Jet& a) {
  const double inverse = 1.0 / a.value;
  return Jet::chain(std::log(a.value), inverse, -inverse * inverse, a);
}
inline Jet sin(const Jet& a) {
  const double sine = std::sin(a.value);
  return Jet::chain(sine, std::cos(a.value), -sine, a);
}
inline Jet cos(const Jet& a) {
  const double cosine = std::cos(a.value);
  return Jet::chain(cosine, -std::sin(a.value), -cosine, a);
}
inline Jet tan(const Jet& a) {
  const double t = std::tan(a.value), slope = 1.0 + t * t;
  return Jet::chain(t, slope, 2.0 * t * slope, a);
}
inline Jet atan(const Jet& a) {
  const double slope = 1.0 / (1.0 + a.value * a.value);
  return Jet::chain(std::atan(a.value), slope, -2.0 * a.value * slope * slope, a);
}
inline Jet asin(const Jet& a) {
  const double inverse = 1.0 / (1.0 - a.value * a.value), slope = std::sqrt(inverse);
  return Jet::chain(std::asin(a.value), slope, a.value * slope * inverse, a);
}
inline Jet acos(const Jet& a) {
  const Jet s = asin(a);
  return {std::acos(a.value), -s.first, -s.second};
}
/// The angle of the direction (x, y).
inline Jet atan2(const Jet& y, const Jet& x) {
  const Jet slope = (Jet{y.first, y.second, 0.0} * Jet{x.value, x.first, 0.0} -
                     Jet{x.first, x.second, 0.0} * Jet{y.value, y.first, 0.0}) /
                    (Jet{x.value, x.first, 0.0} * Jet{x.value, x.first, 0.0} +
                     Jet{y.value, y.first, 0.0} * Jet{y.value, y.first, 0.0});
  return {std::atan2(y.value, x.value), slope.value, slope.first};
}

}  // namespace loadpath::numerics
