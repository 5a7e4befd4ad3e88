// What is refused before a text reaches the TOML parser: Debian's toml++ 3.3 is undefined on bad UTF-8 and on control
// characters, and goes down by a call for each table within another. Letters outside ASCII it never sees (ascii.hpp).
#pragma once

#include "lib/text/issue.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace loadpath::toml {

inline constexpr std::size_t largest_file = std::size_t{4} << 20U;

/// The first thing that cannot be passed on, with its place.
std::optional<Issue> refuse_text(std::string_view text, const std::string& file);

/// What is no TOML, or no project: a character outside ASCII that stands neither in quotes nor in a comment, without a
/// hint, and tables that lie too deep within one another.
std::optional<Issue> refuse_bare(std::string_view text, const std::string& file);

}  // namespace loadpath::toml
