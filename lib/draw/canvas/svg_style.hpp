// The styles of all figures: colours by CSS variables that a page may redefine, with fallbacks for a figure alone.
#pragma once

#include <string>

namespace loadpath::draw {

/// The rules for the classes that figures use, within an element of class "lp".
std::string style_sheet();

}  // namespace loadpath::draw
