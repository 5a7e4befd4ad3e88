// A place in a text that is being read, and the few steps that numbers and units share.
#pragma once

#include "lib/text/utf8.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace loadpath {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_latin(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

inline constexpr std::array<std::string_view, 5> spaces = {" ", "\t", "\u00A0", "\u2009", "\u202F"};
inline constexpr std::array<std::string_view, 10> superscripts = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

struct Cursor {
  std::string_view text;
  std::size_t at = 0;

  [[nodiscard]] bool done() const { return at >= text.size(); }
  [[nodiscard]] char peek(std::size_t ahead = 0) const { return at + ahead < text.size() ? text[at + ahead] : '\0'; }
  [[nodiscard]] bool digit(std::size_t ahead = 0) const { return is_digit(peek(ahead)); }
  [[nodiscard]] bool starts(std::string_view word) const {
    return peek() == word[0] && text.compare(at, word.size(), word) == 0;
  }
  [[nodiscard]] std::size_t character() const { return character_length(text, at); }

  bool take(std::string_view word) {
    if (!starts(word)) return false;
    at += word.size();
    return true;
  }
  /// The first of `words` that the text continues with, or an empty view.
  template <class Words>
  std::string_view take_any(const Words& words) {
    for (const std::string_view word : words)
      if (take(word)) return word;
    return {};
  }
  std::string_view digits() {
    const std::size_t from = at;
    while (digit()) ++at;
    return text.substr(from, at - from);
  }
  void skip_spaces() {
    while (!take_any(spaces).empty()) {
    }
  }
  /// "12", "-12", "−12": with an ASCII sign; empty, and nothing consumed, if no integer follows.
  std::string signed_integer();
  /// "⁻¹" as "-1"; empty if no superscript follows.
  std::string superscript();
};

}  // namespace loadpath
