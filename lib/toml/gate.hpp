// Checks before a text reaches the TOML parser: Debian's toml++ 3.3 is undefined on bad UTF-8 and on control
// characters, and recurses for each nested table. It never sees letters outside ASCII (ascii.hpp).
#pragma once

#include "lib/text/issue.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace loadpath::toml {

inline constexpr std::size_t largest_file = std::size_t{4} << 20U;

/// The first thing that cannot be passed on, with its place.
std::optional<Issue> refuse_text(std::string_view text, const std::string& file);

/// Text that is not TOML, or not a project: a character outside ASCII outside quotes and comments, without a hint,
/// and too deeply nested tables.
std::optional<Issue> refuse_bare(std::string_view text, const std::string& file);

}  // namespace loadpath::toml
