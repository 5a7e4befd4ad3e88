// The words of a choice as shown to the user, and those that are accepted. An empty word means "not given": it is
// neither.
#pragma once

#include "lib/calculator/record.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath {

inline std::vector<std::string> words_to_type(const FieldInfo& choice) {
  std::vector<std::string> words;
  for (const ChoiceInfo& c : choice.choices) {
    if (*c.key != '\0') words.emplace_back(c.key);
  }
  return words;
}

/// Whether a word only says that nothing is stated, as an input that is not given does.
inline bool states_nothing(const ChoiceInfo& choice) {
  return *choice.key == '\0' || std::string_view(choice.doc).starts_with("not stated") ||
         std::string_view(choice.key) == "unknown";
}

/// The words that state something, each with its alias: "pinned_pinned (or pinned)".
inline std::vector<std::string> words_to_choose(const FieldInfo& choice) {
  std::vector<std::string> words;
  for (const ChoiceInfo& c : choice.choices) {
    if (states_nothing(c)) continue;
    words.emplace_back(c.key);
    if (*c.also != '\0') words.back().append(" (or ").append(c.also).append(")");
  }
  return words;
}

/// The aliases of words: accepted, and not shown in lists.
inline std::vector<std::string> aliases_of_words(const FieldInfo& choice) {
  std::vector<std::string> words;
  for (const ChoiceInfo& c : choice.choices) {
    if (*c.also != '\0') words.emplace_back(c.also);
  }
  return words;
}

/// The number of the choice that has this word or alias; nothing if none has.
inline std::optional<double> number_of_word(const FieldInfo& choice, std::string_view word) {
  const auto found = std::find_if(choice.choices.begin(), choice.choices.end(),
                                  [&](const ChoiceInfo& c) { return word == c.key || word == c.also; });
  if (word.empty() || found == choice.choices.end()) return std::nullopt;
  return static_cast<double>(found - choice.choices.begin());
}

}  // namespace loadpath
