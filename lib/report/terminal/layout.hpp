// Text in the width of the terminal: columns whose cells are broken between words, and paragraphs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::terminal {

/// The number of characters in a line on standard output: the width of the terminal, from 80 to 120; 100 without one.
std::size_t line_width();

/// Rows of cells as columns of at most `width` characters together; wider only where a word is.
std::string columns(const std::vector<std::vector<std::string>>& rows, std::size_t width = line_width());

/// A text in lines of at most `width` characters, those behind the first indented by `hang`.
std::string paragraph(const std::string& text, std::size_t hang = 0, std::size_t width = line_width());

}  // namespace loadpath::terminal
