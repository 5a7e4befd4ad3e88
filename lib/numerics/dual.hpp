// Numbers with their derivatives: forward differentiation, exact to rounding. A function written as a template on its
// scalar gives, for these, its value and its derivatives with respect to several parameters at once.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace loadpath::numerics {

/// A value and its derivatives with respect to `lanes` parameters. Comparisons are those of the values, so a branch is
/// differentiated as it is taken; where it changes, the derivative is that of one side.
template <std::size_t lanes>
struct DualNumber {
  double value = 0.0;
  std::array<double, lanes> d{};

  constexpr DualNumber() = default;
  constexpr DualNumber(double v) : value{v} {}  // a constant; implicit, as a number is one

  /// The chain rule for a function with this value and slope at a.
  static constexpr DualNumber chain(double value, double slope, const DualNumber& a) {
    DualNumber r(value);
    for (std::size_t k = 0; k < lanes; ++k) r.d[k] = slope * a.d[k];
    return r;
  }
  /// The same of two arguments.
  static constexpr DualNumber chain(double value, double slope_a, const DualNumber& a, double slope_b,
                                    const DualNumber& b) {
    DualNumber r(value);
    for (std::size_t k = 0; k < lanes; ++k) r.d[k] = slope_a * a.d[k] + slope_b * b.d[k];
    return r;
  }

  friend constexpr DualNumber operator+(const DualNumber& a, const DualNumber& b) {
    return chain(a.value + b.value, 1.0, a, 1.0, b);
  }
  friend constexpr DualNumber operator-(const DualNumber& a, const DualNumber& b) {
    return chain(a.value - b.value, 1.0, a, -1.0, b);
  }
  friend constexpr DualNumber operator-(const DualNumber& a) { return chain(-a.value, -1.0, a); }
  friend constexpr DualNumber operator*(const DualNumber& a, const DualNumber& b) {
    return chain(a.value * b.value, b.value, a, a.value, b);
  }
  friend constexpr DualNumber operator/(const DualNumber& a, const DualNumber& b) {
    const double inverse = 1.0 / b.value, quotient = a.value * inverse;
    return chain(quotient, inverse, a, -quotient * inverse, b);
  }
  constexpr DualNumber& operator+=(const DualNumber& b) { return *this = *this + b; }
  constexpr DualNumber& operator-=(const DualNumber& b) { return *this = *this - b; }
  constexpr DualNumber& operator*=(const DualNumber& b) { return *this = *this * b; }

  friend constexpr bool operator<(const DualNumber& a, const DualNumber& b) { return a.value < b.value; }
  friend constexpr bool operator>(const DualNumber& a, const DualNumber& b) { return a.value > b.value; }
  friend constexpr bool operator==(const DualNumber& a, const DualNumber& b) { return a.value == b.value; }

  friend DualNumber sqrt(const DualNumber& a) {
    const double root = std::sqrt(a.value);
    return chain(root, 0.5 / root, a);
  }
  /// At zero the derivative is set to zero, as for the length of a force that vanishes with its cause.
  friend DualNumber hypot(const DualNumber& a, const DualNumber& b) {
    const double h = std::hypot(a.value, b.value), inverse = h > 0.0 ? 1.0 / h : 0.0;
    return chain(h, a.value * inverse, a, b.value * inverse, b);
  }
  friend DualNumber sin(const DualNumber& a) { return chain(std::sin(a.value), std::cos(a.value), a); }
  friend DualNumber cos(const DualNumber& a) { return chain(std::cos(a.value), -std::sin(a.value), a); }
  friend DualNumber tan(const DualNumber& a) {
    const double t = std::tan(a.value);
    return chain(t, 1.0 + t * t, a);
  }
  friend DualNumber atan2(const DualNumber& y, const DualNumber& x) {
    const double inverse = 1.0 / (x.value * x.value + y.value * y.value);
    return chain(std::atan2(y.value, x.value), x.value * inverse, y, -y.value * inverse, x);
  }
  friend DualNumber abs(const DualNumber& a) { return a.value < 0.0 ? -a : a; }
  friend DualNumber copysign(const DualNumber& a, const DualNumber& sign) {
    return std::signbit(a.value) == std::signbit(sign.value) ? a : -a;
  }
  friend DualNumber round(const DualNumber& a) { return std::round(a.value); }
};

/// The size fills the registers of most CPUs well.
using Dual = DualNumber<8>;

inline double value_of(double number) { return number; }
inline double value_of(const Dual& number) { return number.value; }

}  // namespace loadpath::numerics
