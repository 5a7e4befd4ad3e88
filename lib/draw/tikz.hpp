// Figures in LaTeX.
#pragma once

#include "lib/figure/figure.hpp"

#include <string>

namespace loadpath::draw {

/// The figure as `svg` draws it, a tikzpicture; the document has the styles of lib/draw/tikz/style.hpp once.
std::string tikz(const figure::Figure& figure);

}  // namespace loadpath::draw
