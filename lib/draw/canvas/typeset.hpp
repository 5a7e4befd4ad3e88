// Words and symbols of a figure as runs of type: phi becomes φ, R_12 an italic R with the subscript 12.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::draw {

struct Run {
  enum class Face { words, symbol, subscript };
  std::string text;
  Face face = Face::words;
};
using Text = std::vector<Run>;

/// Marks a name as a symbol inside a longer text: say("{1} in {2}", symbol("M"), "N·m"). Other words stay as they are.
std::string symbol(std::string_view words);

/// A text that is one name is a symbol (M, tau_adm); so are names with a subscript and marked ones in a longer text.
Text typeset(std::string_view words);
/// A number of an axis with the sign of mathematics in place of a hyphen.
std::string with_minus(std::string number);

/// The same on one line for screen readers: τ_adm.
std::string plain(std::string_view words);

/// About as wide as a common sans serif face sets it, never much less.
double width(const Text& text, double size);

}  // namespace loadpath::draw
