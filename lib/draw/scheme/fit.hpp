// Places a mechanism on the page: the points that can be drawn, the scale of lengths and that of forces.
#pragma once

#include "lib/draw/canvas/view.hpp"
#include "lib/figure/figure.hpp"

namespace loadpath::draw {

/// The scheme without gaps: points, forces and couples that were not computed or are zero.
figure::Scheme without_gaps(const figure::Scheme& scheme);

struct Fit {
  double scale = 1.0;   // view units per metre
  double newton = 1.0;  // view units per newton
  Point origin;
  double height = 0.0;

  [[nodiscard]] Point at(Point p) const { return {origin.x + scale * p.x, origin.y - scale * p.y}; }
  [[nodiscard]] Point back(Point view) const { return {(view.x - origin.x) / scale, (origin.y - view.y) / scale}; }
  [[nodiscard]] Point tip(const figure::Scheme::Arrow& arrow) const {
    return at(arrow.at) + newton * Point{arrow.force.x, -arrow.force.y};
  }
};

/// The largest drawing with equal scales in x and y that holds all signs and a quarter of its size for the largest
/// force.
Fit fit(const figure::Scheme& scheme);
/// The same for all positions of a scheme that moves.
Fit fit(const figure::Motion& motion);

}  // namespace loadpath::draw
