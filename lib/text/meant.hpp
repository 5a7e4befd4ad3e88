// The intended meaning of a wrong word, with the meanings of the right ones.
#pragma once

#include "lib/text/issue.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath {

/// A word that may be typed, and what it means.
struct Known {
  std::string word;
  std::string meaning;
};

/// "did you mean 'd_bore' (bore diameter)?": the nearest by name, longer ones that begin alike, else those in
/// whose meaning the word is; three at most, behind `prefix`. `otherwise` where there is none.
Message meant(std::string_view word, const std::vector<Known>& known, Message otherwise,
              const std::string& prefix = {});

/// "available: l (length), d (diameter)"; of many the words only.
Message there_is(const std::vector<Known>& known);

}  // namespace loadpath
