// Capabilities of a terminal for the short answer: its width, and the symbols of its locale.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::terminal {

struct Look {
  std::size_t width = 80;
  bool utf8 = true;
};
/// For standard output: the width of the terminal from 60 to 120, 80 if there is none; without UTF-8 if the locale
/// names another encoding.
Look look_of_output();

/// Ten cells, full at 1; an arrow in the last one beyond it.
std::string bar(double utilisation, const Look& look);
/// The text in the signs that the locale has; spaces that kept values on one line become plain ones.
std::string in_signs_of(std::string text, const Look& look);

/// A text in lines of at most `width` characters; those behind the first are indented by `hang` more. A word that is
/// longer is broken.
std::vector<std::string> lines_of(const std::string& text, std::size_t width, std::size_t hang = 0);
/// Characters, not bytes.
std::size_t length_of(const std::string& text);
std::string padded(std::string text, std::size_t width);

}  // namespace loadpath::terminal
