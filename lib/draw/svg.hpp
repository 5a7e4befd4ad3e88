// Figures as SVG files.
#pragma once

#include "lib/figure/figure.hpp"

#include <string>

namespace loadpath::draw {

/// The figure as one <svg> element: no script, no external reference, colours by CSS variables with fallbacks,
/// <title> and <desc>, all text escaped. Deterministic to the byte.
std::string svg(const figure::Figure& figure);

}  // namespace loadpath::draw
