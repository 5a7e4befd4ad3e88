// Search for words in short texts: in any case, with or without umlauts, in Latin and Cyrillic letters.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace loadpath {

/// The words of a text as searches compare them: small letters and digits; ä, ae as a, ß as ss, ё as е.
std::vector<std::u32string> search_words(std::string_view text);

/// How a text holds the words that are searched for, the best first.
enum class Match {
  whole,      // it is these words
  phrase,     // it holds them one behind the other
  words,      // it holds all of them
  beginning,  // words of it begin with them: "lubric" of "lubrication"
  inside,     // they are parts of its words: "riemen" of "Keilriemen"
  none
};

/// Endings of plural and case do not count: "gears" is "gear", "валы" is "вал".
Match match(const std::vector<std::u32string>& searched, const std::vector<std::u32string>& text);

/// Whether all words of `fewer` are among those of `more`.
bool holds_words(const std::vector<std::u32string>& more, const std::vector<std::u32string>& fewer);

}  // namespace loadpath
