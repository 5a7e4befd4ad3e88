// Subjects that users look for in a design program and that this one does not include.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace loadpath::cli {

struct NotIncluded {
  const char* what;     // "bolted joints and screw threads"
  const char* words;    // that people search by, separated by ", "
  const char* nearest;  // ids of calculators, separated by ", "; may be empty
};

/// The complete list.
std::span<const NotIncluded> not_included();

/// Those of which a search holds a name. `exactly`: only those that it is a name of.
std::vector<const NotIncluded*> not_included(std::string_view text, bool exactly);

}  // namespace loadpath::cli
