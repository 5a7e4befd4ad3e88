// A page in fewer bytes, for a browser the same document.
#pragma once

#include <string>
#include <string_view>

namespace loadpath::report {

/// The page without the end tags and the quotation marks that HTML does not need (HTML Living Standard, 13.1.2);
/// scripts, styles and preformatted text are kept as they are.
std::string compact(std::string_view page);

}  // namespace loadpath::report
