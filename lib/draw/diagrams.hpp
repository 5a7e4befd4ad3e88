// The diagrams of a shaft below its picture, one under the other, with lines through all of them at the named
// sections.
#pragma once

#include "lib/draw/canvas/picture.hpp"
#include "lib/draw/canvas/ticks.hpp"

namespace loadpath::draw {

/// From `top` down; `along`: where the shaft begins and ends, in view units; `length`: its own, m.
Picture diagrams(const figure::Shaft& shaft, Range along, double length, double top);

}  // namespace loadpath::draw
