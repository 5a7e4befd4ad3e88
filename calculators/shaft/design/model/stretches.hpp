// Each stretch of a shaft between two neighbouring places: its bending, twist and weight.
#pragma once

#include "calculators/shaft/design/model/shape.hpp"
#include "lib/beam/beam.hpp"
#include "lib/beam/swing.hpp"

namespace loadpath::shaft {

/// A place within a taper: where it is stressed most, or where it tires first.
struct CriticalPlace {
  double x = 0.0;
  std::size_t piece = 0;
  bool tires = false;
};
using CriticalPlaces = List<CriticalPlace, 2 * most_pieces>;

/// The places where something changes, and points between them; the piece of every span. SI.
struct Stations {
  beam::Row<double> x;
  beam::Row<std::size_t> piece;                      // segment to the right of each x but the last
  CriticalPlaces weakest = {};                       // that are among them
  [[nodiscard]] std::size_t at(Length place) const;  // the nearest
};

struct Stretch {
  beam::Span bends;
  double twists = 0.0;                       // the integral of 1/(G I_p), rad/(N m)
  double most_twist = 0.0;                   // 1/(G I_p) where it is thinnest, rad/(N m^2)
  double left_mass = 0.0, right_mass = 0.0;  // lumped at its ends, sum: its own, kg; NaN without the density
  double left_I_d = 0.0, right_I_d = 0.0;    // halves, slice by slice about their diameters, kg m^2
  beam::OfEnds weighs{};                     // forces and couples on its ends under gravity of 1 m/s^2
};
beam::Row<Stretch> stretches_of(const DesignInput& in, const Stations& stations);

/// The same for torsional vibration, from `from` to `to` along the shaft: of a taper two rods for each of its
/// parts.
void add_rods(const DesignInput& in, double from, double to, beam::Swing::Rods& rods);

}  // namespace loadpath::shaft
