// The diagrams of a shaft below its picture, one under the other, and through all of them the sections that are told
// apart.
#pragma once

#include "lib/draw/canvas/picture.hpp"
#include "lib/draw/canvas/ticks.hpp"

namespace loadpath::draw {

/// From `top` down; `along`: where the shaft begins and ends, in view units; `length`: its own, m.
Picture diagrams(const Shaft& shaft, Range along, double length, double top);

}  // namespace loadpath::draw
