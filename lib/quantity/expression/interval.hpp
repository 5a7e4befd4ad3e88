// Numbers between bounds: they enclose a function everywhere between two places. Each bound is moved outwards by a
// rounding, so that it holds in floating point too.
#pragma once

#include <initializer_list>
#include <limits>

namespace loadpath {

struct Interval {
  double low = 0.0, high = 0.0;

  [[nodiscard]] static Interval everything() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {-infinity, infinity};
  }
  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] double magnitude() const { return high > -low ? high : -low; }
  [[nodiscard]] bool holds(double x) const { return x >= low && x <= high; }
  [[nodiscard]] bool is_bounded() const;
};

Interval operator-(const Interval& a);
Interval operator+(const Interval& a, const Interval& b);
Interval operator-(const Interval& a, const Interval& b);
Interval operator*(const Interval& a, const Interval& b);
Interval operator/(const Interval& a, const Interval& b);
/// The intersection; the first interval if it is empty, which only rounding can cause.
Interval both(const Interval& a, const Interval& b);
/// The least interval that holds both.
Interval joined(const Interval& a, const Interval& b);

/// Widens the bounds by a rounding or two: functions of the C library may be wrong in the last digit. NaN gives the
/// entire range.
Interval outward(double low, double high);
/// The smallest interval that contains all of these, widened by a rounding; the entire range if one is NaN.
Interval hull(std::initializer_list<double> values);
/// To a constant power; everything where it is not defined everywhere.
Interval to_power(const Interval& a, double exponent);

/// Bounds of a function of one variable and of its derivatives, by the rules of differentiation.
struct IntervalJet {
  Interval value, first, second;
};

}  // namespace loadpath
