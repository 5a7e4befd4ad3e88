// The styles of lib/draw/canvas/style.hpp for pictures in LaTeX.
#pragma once

#include <string>
#include <string_view>

namespace loadpath::draw {

inline constexpr double tikz_unit = 0.75;  // big points to a view unit: a picture is 127 mm wide, its text 9.75 pt high

/// Colours ("lpink") and styles ("lp grid", "lp words quiet") for the head of a document that loads TikZ.
std::string tikz_styles();

/// The styles of an element with these classes, in the order of the rules: "lp curve,lp c1".
std::string tikz_style(std::string_view classes);
/// The same for words: "lp words,lp words quiet".
std::string tikz_words(std::string_view classes);
/// Whether words of these classes have the paper's colour around them.
bool has_halo(std::string_view classes);

}  // namespace loadpath::draw
