// Rounding errors in the results of a mechanism: distinguished from values by the size of the terms.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/quantity/dimension.hpp"
#include "lib/quantity/series.hpp"

#include <vector>

namespace loadpath::planar {

/// Rounding error of a zero at a position, relative to the largest reaction and its moment about the origin.
struct Rounding {
  double force = 0.0;   // N
  double moment = 0.0;  // N m
};
Rounding rounding_at(const mechanism::Position& p);

/// The direction of a vector in (-pi, pi]: along the x axis, in either direction, to rounding just 0 or pi.
double direction_of(mechanism::Vec v);

/// The largest magnitudes over the positions of a cycle. Vectors have their largest squares: the root of the largest
/// is the largest length.
struct Magnitudes {
  double length = 0.0, speed = 0.0, acceleration = 0.0;  // values of links' origins, squared
  double turning = 0.0, angular_acceleration = 0.0;      // values of links
  double force = 0.0, couple = 0.0;                      // values of joints, drives and loads; the forces squared

  /// Unknown values are skipped.
  void see(const mechanism::Position& p, const std::vector<mechanism::Driver>& drivers);
};
/// Magnitudes over the positions that close.
Magnitudes magnitudes_of(const mechanism::Model& model, const Cycle& cycle);

/// Rounding errors in results: a sum is as exact as its largest term, a force one of forces, a moment of moments and
/// of forces at the mechanism's arms, a power of forces at its speeds. These magnitudes follow from the cycle, not
/// from the results that happen to be wanted.
class ResultRounding {
 public:
  ResultRounding(const mechanism::Model& model, const Magnitudes& of);

  /// Gives a result the size of its rounding, sets smaller values to zero, and removes meaningless digits. For a
  /// `direction` half a revolution is positive.
  void clear(Value& value, bool direction) const;

 private:
  struct Scale {
    Dimension dimension;
    double largest = 0.0;
  };
  std::vector<Scale> scales_;
};

}  // namespace loadpath::planar
