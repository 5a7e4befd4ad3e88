// Texts that must do with a number of lines: what does not fit is left out, and said to be.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::cli {

constexpr std::size_t screen_width = 80, screen_lines = 30;
constexpr std::size_t label_width = 11;  // "Required   "

using Lines = std::vector<std::string>;

/// Characters, not bytes.
std::size_t length_of(std::string_view text);

/// A text behind a label, its further lines indented as far.
Lines labelled(const std::string& label, const std::string& text);

/// Items behind a label, as many as fit into the lines, then how many more there are; `where` names their place.
Lines listed(const std::string& label, const std::vector<std::string>& items, const std::string& separator,
             std::size_t most, const std::string& where);

/// The sentences of a text that fit into the lines, one at least.
Lines sentences(std::string_view text, std::size_t most);

/// The longest complete phrase of a meaning that fits into `width`: the part before a semicolon, or before a colon, a
/// comma or a parenthesis of the first clause; if none fits, complete words and an ellipsis.
std::string shortened(const std::string& meaning, std::size_t width);

}  // namespace loadpath::cli
