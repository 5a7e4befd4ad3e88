// The form of values: spaces, indents and quotes.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::toml {

/// The replacement of a text in plain quotes, by the keys that lead to it from the value: { a = { b = "1mm" } }: "a"
/// "b".
using Rewrite = std::function<std::string(const std::vector<std::string>& keys, const std::string& text)>;

/// A value with one space around =, behind commas and inside of braces, in the lines that it has, those within brackets
/// indented by two spaces; texts in double quotes where they need no others, as `rewrite` has them.
std::string laid_out(std::string_view value, const Rewrite& rewrite);

}  // namespace loadpath::toml
