// Pictures as SVG: at most two decimals, text escaped, never a number that is not finite.
#pragma once

#include "lib/draw/canvas/picture.hpp"

#include <string>
#include <string_view>

namespace loadpath::draw {

/// The <svg> element around a picture, as a separate file.
std::string svg_file(const Picture& picture, std::string_view title);
/// The same for a page that has the style sheet once.
std::string svg_part(const Picture& picture, std::string_view title);

}  // namespace loadpath::draw
