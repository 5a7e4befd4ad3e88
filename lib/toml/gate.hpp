// What is refused before a text reaches the TOML parser: Debian's toml++ 3.3 is undefined on bad UTF-8, on control
// characters, on letters outside ASCII that stand in no quotes, and on those behind a backslash in a long text.
#pragma once

#include "lib/text/issue.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace loadpath::toml {

inline constexpr std::size_t largest_file = std::size_t{4} << 20U;

/// The first thing that cannot be passed on, with its place.
std::optional<Issue> refuse_text(std::string_view text, const std::string& file);

/// What is no TOML, or no project, and what the parser does not stand: a character outside ASCII that stands neither in
/// quotes nor in a comment, without a hint, and tables that lie too deep within one another.
std::optional<Issue> refuse_bare(std::string_view text, const std::string& file);

}  // namespace loadpath::toml
