// Drawings for CAD: DXF of AutoCAD R12, which every program reads. Lengths in mm.
#pragma once

#include "lib/figure/figure.hpp"

#include <string>

namespace loadpath::draw {

/// Links as lines on a layer of their own name, pins as circles on the layer "pins", guides as lines on "guides".
/// Parts without a position are left out.
std::string dxf_of(const figure::Scheme& scheme);

/// Whether a figure is drawn to one scale: a scheme, or a drawing.
bool is_to_scale(const figure::Figure& figure);

/// For a scheme or a drawing: the views of a drawing side by side, each 1:1, on layers by the kind of line;
/// dimensions as lines and texts on the layer "dimensions". Empty for other figures.
std::string dxf_of(const figure::Figure& figure);

}  // namespace loadpath::draw
