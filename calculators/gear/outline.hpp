// The outlines of gears, for pictures: involute flanks, fillets of the generating rack, tip and root arcs.
#pragma once

#include "calculators/gear/tooth_form.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/whole.hpp"

#include <vector>

namespace loadpath::gear {

/// A wheel or ring in the transverse plane, lengths in metres.
struct Body {
  Rack rack;         // in transverse modules
  double m_t = 0.0;  // transverse module
  Whole z = 0;
  double x = 0.0;  // profile shift in transverse modules
  double r_a = 0.0, r_f = 0.0;
  figure::Point at;   // the axis
  double turn = 0.0;  // direction of the middle of a tooth (of a space of a ring), rad
};

/// The closed outline of a wheel with outer teeth.
[[nodiscard]] std::vector<figure::Point> wheel_outline(const Body& body);
/// The closed inner outline of a ring.
[[nodiscard]] std::vector<figure::Point> ring_outline(const Body& body);
/// The closed outline of a rack segment with its reference line at x = at.x, teeth to the left; y = at.y is the
/// middle of the segment: a space if the number of teeth is even.
[[nodiscard]] std::vector<figure::Point> rack_outline(const Rack& rack, double m_t, double h_a, int teeth,
                                                      figure::Point at);

}  // namespace loadpath::gear
