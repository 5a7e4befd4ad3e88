// A text in letters of ASCII alone, and the way back: Debian's toml++ 3.3 is undefined where a letter outside ASCII
// stands in no quotes, or behind a backslash, and only a parser knows where that is. So it never sees one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loadpath::toml {

class Ascii {
 public:
  /// Of well-formed UTF-8. A byte order mark at the beginning stays.
  explicit Ascii(std::string_view original);

  [[nodiscard]] const std::string& text() const { return text_; }
  /// What a part of text() was in the original.
  [[nodiscard]] std::string original(std::string_view part) const;
  /// The column, in code points from 1, where the original has what stands in a line and column of text().
  [[nodiscard]] int column(int line, int column) const;

 private:
  void add(char32_t foreign, int line, std::size_t start_of_line);

  std::string mark_;  // before the number of a code point; occurs nowhere in the original
  std::string text_;
  std::vector<std::pair<int, int>> places_;  // line and column in text() of each code point that is written as a number
};

}  // namespace loadpath::toml
