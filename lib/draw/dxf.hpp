// The drawing of a mechanism for CAD: DXF of AutoCAD R12, which every program reads.
#pragma once

#include "lib/figure/figure.hpp"

#include <string>

namespace loadpath::draw {

/// Links as lines on a layer of their own name, pins as circles on the layer "pins", guides as lines on "guides".
/// Lengths in mm. What has no place is left out.
std::string dxf_of(const draw::Scheme& scheme);

}  // namespace loadpath::draw
