// Fewer points for the same picture.
#pragma once

#include "lib/draw/canvas/view.hpp"

#include <vector>

namespace loadpath::draw {

/// The polyline without points that lie closer than `tolerance` to it; of more than 800 that remain, the extremes of
/// each narrow column. Ends are kept.
std::vector<Point> thin(const std::vector<Point>& points, double tolerance = 0.08);

/// The polyline without points that lie closer than `tolerance` to it, however many remain: of outlines, which go back
/// and forth.
std::vector<Point> simplified(const std::vector<Point>& points, double tolerance = 0.08);

}  // namespace loadpath::draw
