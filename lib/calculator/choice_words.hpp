// The words of a choice as shown to the user. An empty word means "not given": it is neither shown nor accepted.
#pragma once

#include "lib/calculator/record.hpp"

#include <string>
#include <vector>

namespace loadpath {

inline std::vector<std::string> words_to_type(const FieldInfo& choice) {
  std::vector<std::string> words;
  for (const ChoiceInfo& c : choice.choices) {
    if (*c.key != '\0') words.emplace_back(c.key);
  }
  return words;
}

}  // namespace loadpath
