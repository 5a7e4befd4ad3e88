// Whether the program reports an error of a project with given words.
#pragma once

#include "tests/lib/project/texts.hpp"

namespace loadpath::test {

/// Whether an issue of the project has these words, in its key, its message or its hint; prints the issues if none
/// has.
inline bool says(const std::string& text, const std::string& words) {
  std::string all;
  for (const Issue& i : told(text).issues) all += i.key + ": " + i.message.text() + "; " + i.hint.text() + "\n";
  const bool said = all.find(words) != std::string::npos;
  if (!said) MESSAGE(all);
  return said;
}

}  // namespace loadpath::test
