// The spandrel between two edges at a right angle and the arc that rounds their corner: the material of a fillet, or
// the part that a rounded edge removes. Exact.
#pragma once

#include "lib/calculator/trace.hpp"

namespace loadpath::section {

struct Corner {
  Area A_r;           // area
  Length e_r;         // from each edge to the centroid
  SecondMoment I_r;   // about the axis through the centroid, parallel to an edge
  SecondMoment I_rp;  // product of area about these axes, where both edges run in positive directions
};

/// Under the symbols that the steps of a section use.
template <class Tracer>
Corner corner(Length r, Tracer& trace) {
  STEP(A_r, (1.0 - pi / 4.0) * r * r, "area of the fillet in one corner");
  STEP(e_r, (10.0 - 3.0 * pi) / (12.0 - 3.0 * pi) * r, "from each edge to the centroid of the fillet");
  STEP(I_r, (1.0 / 3.0 - pi / 16.0 - 1.0 / (3.0 * (12.0 - 3.0 * pi))) * pow<4>(r),
       "second moment of the fillet about its own centroid");
  return {A_r, e_r, I_r, (19.0 / 24.0 - pi / 4.0) * pow<4>(r) - A_r * e_r * e_r};
}

}  // namespace loadpath::section
