// Pictures for LaTeX, as commands of TikZ.
#pragma once

#include "lib/draw/canvas/picture.hpp"

#include <string>

namespace loadpath::draw {

/// A tikzpicture; the document has the styles of style.hpp once.
std::string tikz(const Picture& picture);

}  // namespace loadpath::draw
