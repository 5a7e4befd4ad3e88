// The layout of a project file: the order of its tables and of the keys of its steps, spaces, quotes, units.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/text/issue.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

/// The text in the standard layout; comments stay with their subjects, and blank lines stay between groups of keys.
/// The meaning is unchanged: the same steps in the same order with the same values. Invalid TOML is an issue.
std::string layout_of(std::string_view text, const std::string& file, Calculators calculators,
                      std::vector<Issue>& issues);

/// "900  N·m" as "900 N*m", to the bit the same quantity; any other text as it is.
std::string plain_quantity(const std::string& text);

}  // namespace loadpath::project
