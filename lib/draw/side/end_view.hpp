// A shaft seen from its right end, with the transverse forces on it to one scale.
#pragma once

#include "lib/draw/canvas/canvas.hpp"
#include "lib/figure/figure.hpp"

namespace loadpath::draw {

inline constexpr double end_view_left = 456.0, end_view_right = 624.0;  // it widens the picture
inline constexpr double end_view_reach = 78.0;                          // its extent above and below the axis

/// Whether one is wanted, forces act in two planes, and no diagrams take the width.
bool has_end_view(const figure::Shaft& shaft);
Canvas end_view(const figure::Shaft& shaft, double axis);

}  // namespace loadpath::draw
