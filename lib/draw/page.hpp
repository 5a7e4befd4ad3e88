// Figures within a page of HTML: one style sheet for all of them.
#pragma once

#include "lib/figure/figure.hpp"

#include <string>

namespace loadpath::draw {

/// The figure as `svg` draws it, without its style sheet (lib/draw/canvas/style.hpp).
std::string svg_in_page(const figure::Figure& figure);
/// Height over width.
double proportion(const figure::Figure& figure);

}  // namespace loadpath::draw
