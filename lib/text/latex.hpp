// Text inside LaTeX.
#pragma once

#include <string>
#include <string_view>

namespace loadpath {

/// Words in which nothing is read as markup, in one paragraph. Letters beyond ASCII stay as they are: that the document
/// knows them is left to its head (lib/report/latex/letters.hpp).
std::string latex_text(std::string_view text);

}  // namespace loadpath
