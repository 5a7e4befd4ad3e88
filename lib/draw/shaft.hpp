// A shaft from the side, in a page or in a file of its own.
#pragma once

#include "lib/draw/canvas/picture.hpp"

namespace loadpath::draw {

/// With its hubs and bearings above diagrams too, for which a page has no height.
Picture picture_in_file(const figure::Shaft& shaft);

}  // namespace loadpath::draw
