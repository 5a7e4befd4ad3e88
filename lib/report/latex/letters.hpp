// Letters beyond ASCII in LaTeX.
#pragma once

#include <string>
#include <string_view>

namespace loadpath::report::tex {

/// What the head of a document has to say so that every letter of its body is known: for each that LaTeX with its T1
/// fonts has no sign for, a sign of mathematics or, where there is none, its number. Cyrillic letters are set where the
/// packages for them are installed.
std::string declared_letters(std::string_view body);

}  // namespace loadpath::report::tex
