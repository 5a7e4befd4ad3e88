// What to write in place of a line that is not valid TOML.
#pragma once

#include "lib/text/issue.hpp"

#include <string_view>

namespace loadpath::toml {

/// The remedy for the commonest mistakes of a line, a quantity without quotes above all; empty for any other. `column`:
/// of a word that is not a value, from 1; else 0.
Message hint_for(std::string_view line, int column);
/// Of lists and tables in braces, by the words of the parser; empty for other faults.
Message hint_for_brackets(std::string_view what, std::string_view line);

}  // namespace loadpath::toml
