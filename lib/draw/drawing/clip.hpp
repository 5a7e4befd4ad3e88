// Clipping to a window, and the hatching of cut faces.
#pragma once

#include "lib/draw/canvas/view.hpp"

#include <utility>
#include <vector>

namespace loadpath::draw {

/// The pieces of a polyline within the box.
std::vector<std::vector<Point>> clipped(const std::vector<Point>& polyline, const Box& box);

/// The part of a closed outline within the box.
std::vector<Point> clipped_area(std::vector<Point> outline, const Box& box);

/// Strokes at 45 degrees through the inside of closed outlines; regions within an even number of them are holes.
std::vector<std::pair<Point, Point>> hatching(const std::vector<Point>& outline, double spacing, bool falling = false);

/// Twice the area over the circumference: of a thin wall its thickness.
double mean_thickness(const std::vector<Point>& outline);

}  // namespace loadpath::draw
