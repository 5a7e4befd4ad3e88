// Rules of the style sheet that a page needs.
#pragma once

#include <string>
#include <string_view>

namespace loadpath::report {

/// The sheet without rules for classes that no element of the page has: of a mechanism that moves, of states that do
/// not occur, of lines that no figure draws.
std::string used_rules(std::string_view sheet, std::string_view page);

}  // namespace loadpath::report
