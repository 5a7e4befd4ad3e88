// Text inside LaTeX.
#pragma once

#include <string>
#include <string_view>

namespace loadpath {

/// Words escaped from markup, in one paragraph. Letters beyond ASCII are unchanged: the head of the document declares
/// them (lib/report/latex/letters.hpp).
std::string latex_text(std::string_view text);

}  // namespace loadpath
