// Moments over the speed, straight between points, and what a run along them takes. SI numbers.
#pragma once

#include <cstddef>
#include <span>

namespace loadpath::machine {

struct LinePoint {
  double omega = 0.0;  // rad/s
  double M = 0.0;      // N m
};

/// The moment at a speed; one point is a constant, none is zero. The ends go on level.
double moment_at(std::span<const LinePoint> line, double omega);

/// A run from one speed to another.
struct Stretch {
  double time = 0.0;   // s
  double angle = 0.0;  // rad
  double taken = 0.0;  // J, by the load
};

/// The run of an inertia from omega_1 to omega_2 while the accelerating moment goes straight from M_1 to M_2, both of
/// the sign of omega_2 - omega_1 and neither zero; the load goes straight from `load_1` to `load_2`.
Stretch run(double inertia, double omega_1, double M_1, double omega_2, double M_2, double load_1, double load_2);

}  // namespace loadpath::machine
