// Names of rows as users type them: case and spaces are ignored; the nearest names to an unknown one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::table {

/// A name without its spaces and hyphens, in small letters ("GG 25", "GG-25"): equal for equal names.
std::u32string folded(std::string_view name);

/// The names that may be meant by one that does not exist: the sizes of its series next below and above ("HEA 155": HEA
/// 140 and HEA 160); of materials the one of the same letters with the nearest number, else the one spelt most alike;
/// none if no name is near.
std::vector<std::string> near_names(std::string_view name, const std::vector<std::string>& names);

}  // namespace loadpath::table
