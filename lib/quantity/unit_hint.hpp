// The remedies for a unit that cannot be read.
#pragma once

#include "lib/quantity/dimension.hpp"
#include "lib/text/issue.hpp"

#include <string>
#include <string_view>

namespace loadpath {

Message unknown_unit(std::string_view name);
Message unknown_unit_hint(std::string_view name);
/// The same where a quantity of one dimension is expected, with `usual` as its unit: "mn" is mm of a length.
Message unknown_unit_hint(std::string_view name, const Dimension& dimension, std::string_view usual);

/// "kNm" as "kN*m": two known names run together; empty for any other name.
std::string split(std::string_view name);

/// Writes `above/below` and then `sign rest` with one division: "N/m*s" as 'N/(m*s)' or 'N*s/m'.
Message one_division(std::string_view above, std::string_view below, char sign, std::string_view rest);

}  // namespace loadpath
