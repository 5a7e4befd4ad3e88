// Prandtl's stress function of a twisted bar whose section is bounded by straight lines, by boundary elements.
//
// phi = psi - r^2/2 with psi harmonic and phi constant along each contour, zero on the outer one; all per G theta. The
// derivative of psi across the contour is constant over each element, and meets Green's third identity in the middle of
// each; the integrals over an element are exact. Elements are smaller toward the corners. The error of I_t falls with
// the third power of their number, that of the stress along sides with the second.
#pragma once

#include <cstddef>
#include <span>

namespace loadpath::numerics {

struct PlanePoint {
  double x, y;
};
/// Corners in order, clockwise or anticlockwise.
using Contour = std::span<const PlanePoint>;

inline constexpr std::size_t most_elements = 160, most_contours = 9;

struct TorsionFunction {
  double I_t;     // torsion constant
  double stress;  // largest in the middle of an element, per G theta: a length
  PlanePoint at;  // its place; the first of equal elements
};

/// The torsion function of a section with an outer contour, the first, and holes inside it. Elements per side times
/// sides must not exceed `most_elements`. Does not allocate.
TorsionFunction torsion_function(std::span<const Contour> contours, std::size_t per_side);

}  // namespace loadpath::numerics
