// Solution of an initial value problem y' = f(t, y) by steps whose length keeps their error below a tolerance
// (Dormand and Prince, order 5), with the places where functions of the solution are zero.
#pragma once

#include <functional>
#include <vector>

namespace loadpath::dynamics {

using Unknowns = std::vector<double>;
using OfUnknowns = std::function<double(double t, const Unknowns& y)>;

struct InitialValue {
  /// NaN where there are no slopes.
  std::function<void(double t, const Unknowns& y, Unknowns& slopes)> slopes;
  double t_1 = 0.0, t_2 = 1.0;  // t_1 < t_2
  Unknowns y;                   // at t_1
  OfUnknowns until = nullptr;   // the solution ends at its first change of sign after t_1
  /// Their changes of sign are visited: at those of its slope a function has its extremes.
  std::vector<OfUnknowns> turns = {};
};

struct Solved {
  enum class End { time, zero, no_slopes, too_many_steps };
  End end = End::time;
  double t = 0.0;
  Unknowns y;
};

/// The error of a step is below `tolerance`, relative to the unknowns and their change in the step. `visit` is called
/// at t_1, after each step, at each turn and at the end, in order of time. No step is longer than 1/500 of t_2 - t_1:
/// two changes of sign that are closer may be missed.
Solved solve(const InitialValue& problem, double tolerance,
             const std::function<void(double t, const Unknowns& y)>& visit);

}  // namespace loadpath::dynamics
