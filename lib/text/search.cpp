#include "lib/text/search.hpp"

#include "lib/text/utf8.hpp"

#include <algorithm>

namespace loadpath {

namespace {

using Words = std::vector<std::u32string>;

constexpr bool is_cyrillic(char32_t p) { return p >= 0x400 && p <= 0x4FF; }

constexpr bool is_letter(char32_t p) {
  return (p >= U'a' && p <= U'z') || (p >= U'0' && p <= U'9') || (p >= 0xDF && p <= 0xFF && p != 0xF7) ||
         is_cyrillic(p);
}

/// A letter without its marks.
std::u32string_view plain(char32_t p) {
  switch (p) {
    case U'ä':
    case U'á':
    case U'à':
    case U'â':
      return U"a";
    case U'ö':
    case U'ó':
    case U'ô':
      return U"o";
    case U'ü':
    case U'ú':
      return U"u";
    case U'é':
    case U'è':
    case U'ê':
      return U"e";
    case U'ß':
      return U"ss";
    case U'ё':
      return U"е";
    default:
      return {};
  }
}

/// "woehler" as "wohler": an umlaut that is written with two letters, on both sides of a comparison.
void join_umlauts(std::u32string& word) {
  for (std::size_t i = 0; i + 1 < word.size(); ++i) {
    const bool first = word[i] == U'a' || word[i] == U'o' || word[i] == U'u';
    if (first && word[i + 1] == U'e') word.erase(i + 1, 1);
  }
}

/// An English word without the ending of its plural.
std::u32string singular(const std::u32string& word) {
  const auto ends = [&](std::u32string_view end) { return word.size() > end.size() + 1 && word.ends_with(end); };
  if (ends(U"sses") || ends(U"ches") || ends(U"shes") || ends(U"xes")) return word.substr(0, word.size() - 2);
  const bool plural = word.size() > 3 && ends(U"s") && !ends(U"ss") && !ends(U"us") && !ends(U"is");
  return plural ? word.substr(0, word.size() - 1) : word;
}

std::size_t common_length(const std::u32string& a, const std::u32string& b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

/// The same word, whatever its number and case.
bool same(const std::u32string& a, const std::u32string& b) {
  if (a == b) return true;
  if (is_cyrillic(a[0]) && is_cyrillic(b[0])) {  // endings of up to two letters
    const std::size_t longer = std::max(a.size(), b.size()), common = common_length(a, b);
    return common >= 3 && common + 2 >= longer;
  }
  return singular(a) == singular(b);
}

bool begins(const std::u32string& text, const std::u32string& searched) {
  return same(text, searched) || (searched.size() >= 3 && text.starts_with(searched));
}

bool is_inside(const std::u32string& text, const std::u32string& searched) {
  return begins(text, searched) || (searched.size() >= 4 && text.find(searched) != std::u32string::npos);
}

template <class Agrees>
bool all_agree(const Words& searched, const Words& text, Agrees agrees) {
  return std::all_of(searched.begin(), searched.end(), [&](const std::u32string& word) {
    return std::any_of(text.begin(), text.end(), [&](const std::u32string& own) { return agrees(own, word); });
  });
}

}  // namespace

Words search_words(std::string_view text) {
  Words words(1);
  for (const char32_t point : code_points(text)) {
    const char32_t p = lower_case(point);
    if (!is_letter(p)) {
      if (!words.back().empty()) words.emplace_back();
      continue;
    }
    const std::u32string_view unmarked = plain(p);
    unmarked.empty() ? words.back().push_back(p) : void(words.back().append(unmarked));
  }
  if (words.back().empty()) words.pop_back();
  for (std::u32string& word : words) join_umlauts(word);
  return words;
}

Match match(const Words& searched, const Words& text) {
  if (searched.empty()) return Match::none;
  const auto phrase = std::search(text.begin(), text.end(), searched.begin(), searched.end(), same);
  if (phrase != text.end()) return searched.size() == text.size() ? Match::whole : Match::phrase;
  if (all_agree(searched, text, same)) return Match::words;
  if (all_agree(searched, text, begins)) return Match::beginning;
  return all_agree(searched, text, is_inside) ? Match::inside : Match::none;
}

bool holds_words(const Words& more, const Words& fewer) { return all_agree(fewer, more, same); }

}  // namespace loadpath
