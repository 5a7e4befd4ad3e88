// Text inside HTML, MathML and attributes.
#pragma once

#include <string>
#include <string_view>

namespace loadpath {

/// & < > " ' as entities; control characters, which no page may hold, are left out.
std::string escaped(std::string_view text);

}  // namespace loadpath
