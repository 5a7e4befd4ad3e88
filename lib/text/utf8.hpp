// Code points of UTF-8 text: columns, cuts and comparisons are counted in them, never in bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace loadpath {

/// The first byte that is not part of well-formed UTF-8; npos if all is well.
std::size_t first_invalid_byte(std::string_view text);

/// The first control character, U+0000 to U+001F or U+007F to U+009F, that is not among `allowed`; npos if there is
/// none. Terminals obey them.
std::size_t first_control(std::string_view text, std::string_view allowed);

/// The number of bytes of the character at `at`: 1 to 4, never past the end of `text`.
std::size_t character_length(std::string_view text, std::size_t at);

/// The code points of `text`; a malformed byte maps to itself.
std::u32string code_points(std::string_view text);

/// The text of code points.
std::string utf8(std::u32string_view points);

/// A Latin (ASCII or Latin-1) or Cyrillic capital as its small letter.
char32_t lower_case(char32_t point);

}  // namespace loadpath
