// A quantity over the positions of a cycle, or a single value, with its dimension; and its properties.
#pragma once

#include "lib/quantity/dimension.hpp"
#include "lib/quantity/places.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath {

/// The positions that a series is given at. One object per step that makes series; its address is its identity.
struct Axis {
  std::string step;           // "lever"
  std::string quantity;       // "crank angle"
  std::string unit = "deg";   // display unit of `at`
  Places at;                  // SI, ascending or descending; a cycle holds no doubled end point
  std::vector<double> share;  // part of the cycle's time that belongs to each position; sums to 1; empty: not a cycle
  double period = 0.0;        // SI, signed; 0: not a cycle
  double speed = 0.0;         // angular velocity of the rotating part, rad/s; 0: unknown, or not constant
  [[nodiscard]] std::string name() const { return step + ": " + quantity; }
  [[nodiscard]] bool cyclic() const { return period != 0.0; }
};

struct Signature {
  Dimension dimension;
  const Axis* axis = nullptr;  // null: one value
  bool other_sign = false;     // a load whose sign, if any, differs from that of tension and compression
};

struct Value {
  Signature signature;
  std::vector<double> si;  // one, or one per position of the axis
  double rounding = 0.0;   // SI: absolute rounding error of the values, from the terms they are computed from
  [[nodiscard]] bool is_series() const { return signature.axis != nullptr; }
};

/// An extreme of a series, refined between positions by the quartic through five of them; if the parabolas through
/// three neighbours each differ by more than a quarter in curvature (a jump, a kink, fewer than about 13 positions to
/// a wave) the position itself is taken. An open axis is never left. Among extremes that differ by no more than the
/// series' rounding, or 1e-12 of their size, the first; a place is zero within 1e-6 of a step.
struct Extreme {
  double value = 0.0;       // SI; NaN for an empty series or one that holds NaN
  double at = 0.0;          // SI, on the axis
  std::size_t nearest = 0;  // index of the nearest position
};
Extreme maximum(const Value& series);
Extreme minimum(const Value& series);
/// The value of largest magnitude, with its sign (`peak` of the expressions is its magnitude).
Extreme largest(const Value& series);
/// Whether the positions of a cycle are dense enough to resolve its extremes: at least 36, and values between them
/// exceed them by no more than 1 % of the range. Always true without a cycle.
bool resolves_extremes(const Value& series);
/// Whether its values differ only by rounding. False for a series with NaN.
bool is_constant(const Value& series);

/// Mean and root mean square over time on the closed cycle (trapezoid, end point counted once); NaN if the series
/// is not a cycle.
double mean(const Value& series);
double root_mean_square(const Value& series);

/// The value at a place of the axis: local cubic between positions, periodic on a cycle; NaN outside an open axis.
double value_at(const Value& series, double at);

}  // namespace loadpath
