#include "lib/toml/ascii.hpp"

#include "lib/text/utf8.hpp"

#include <algorithm>
#include <charconv>

namespace loadpath::toml {

namespace {

constexpr int hexadecimal = 16;
constexpr std::size_t digits = 6;  // digits of U+10FFFF

bool is_foreign(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// No escape begins with z, and the mark cannot overlap with itself.
std::string mark_for(std::string_view text) {
  for (int i = 0;; ++i) {
    std::string mark = "z" + std::to_string(i) + "_";
    if (text.find(mark) == std::string_view::npos) return mark;
  }
}

}  // namespace

Ascii::Ascii(std::string_view original) : mark_(mark_for(original)) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  std::size_t i = original.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  text_ = original.substr(0, i);
  int line = 1;
  std::size_t start = i;  // start of the line in text_
  while (i < original.size()) {
    if (is_foreign(original[i])) {
      const std::size_t length = character_length(original, i);
      add(code_points(original.substr(i, length))[0], line, start);
      i += length;
      continue;
    }
    text_ += original[i];
    if (original[i++] == '\n') ++line, start = text_.size();
  }
}

void Ascii::add(char32_t foreign, int line, std::size_t start_of_line) {
  places_.emplace_back(line, static_cast<int>(text_.size() - start_of_line) + 1);
  std::string number;
  for (std::size_t k = 0; k < digits; ++k, foreign /= hexadecimal) number += "0123456789abcdef"[foreign % hexadecimal];
  text_ += mark_;
  text_.append(number.rbegin(), number.rend());
}

std::string Ascii::original(std::string_view part) const {
  std::string out;
  for (std::size_t at = part.find(mark_); at != std::string_view::npos; at = part.find(mark_)) {
    out += part.substr(0, at);
    const std::string_view number = part.substr(at + mark_.size()).substr(0, digits);
    std::uint32_t point = 0;
    std::from_chars(number.data(), number.data() + number.size(), point, hexadecimal);
    out += utf8(std::u32string(1, static_cast<char32_t>(point)));
    part.remove_prefix(at + mark_.size() + number.size());
  }
  return out += part;
}

int Ascii::column(int line, int column) const {
  const auto first = std::lower_bound(places_.begin(), places_.end(), std::pair(line, 0));
  const auto end = std::lower_bound(first, places_.end(), std::pair(line, column));
  const int width = static_cast<int>(mark_.size() + digits);
  if (first == end) return column;
  const int within = std::min(column - std::prev(end)->second, width);  // width of the previous one
  const int before = static_cast<int>(end - first);
  return column - (before - 1) * (width - 1) - within + (within < width ? 0 : 1);
}

}  // namespace loadpath::toml
