// Letters beyond ASCII in LaTeX.
#pragma once

#include <string>
#include <string_view>

namespace loadpath::report::tex {

/// The declarations in the head of a document for the letters of its body: for each that LaTeX with its T1 fonts
/// cannot set, a mathematical symbol or, if there is none, its number. Cyrillic letters are set if their packages
/// are installed.
std::string declared_letters(std::string_view body);

}  // namespace loadpath::report::tex
