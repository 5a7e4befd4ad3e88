// Names of rows as users type them: case and spaces are ignored; the nearest name to an unknown one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::table {

/// A name without its spaces and hyphens, in small letters ("GG 25", "GG-25"): equal for equal names.
std::u32string folded(std::string_view name);

/// The name that is meant by one that is not there: of the same letters in front the one with the nearest number ("HEA
/// 155": HEA 160, "S35": S235JR), else the one that is spelt most alike; empty if none is near.
std::string near_name(std::string_view name, const std::vector<std::string>& names);

}  // namespace loadpath::table
