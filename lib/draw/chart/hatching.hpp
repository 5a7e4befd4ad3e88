// Strokes through a region of any shape, cut where it ends: no pattern that a viewer must know.
#pragma once

#include "lib/draw/canvas/view.hpp"

#include <functional>
#include <vector>

namespace loadpath::draw {

using Strokes = std::vector<std::pair<Point, Point>>;

/// Through all places of the area where `holds`, rising or falling to the right.
Strokes hatching(const Box& area, double spacing, bool rising, const std::function<bool(Point)>& holds);

}  // namespace loadpath::draw
