// A plot as one of several below each other.
#pragma once

#include "lib/draw/canvas/picture.hpp"
#include "lib/draw/plot/frame.hpp"

namespace loadpath::draw {

/// In the place of the page that the strip has; the picture's height is where it ends.
Picture picture(const figure::Plot& plot, const Strip& strip);

}  // namespace loadpath::draw
