// A text in ASCII letters only, and the conversion back: Debian's toml++ 3.3 is undefined for a letter outside ASCII
// without quotes, or after a backslash, and only a parser knows where that is. So it never sees one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loadpath::toml {

class Ascii {
 public:
  /// For well-formed UTF-8. A byte order mark at the beginning stays.
  explicit Ascii(std::string_view original);

  [[nodiscard]] const std::string& text() const { return text_; }
  /// The original text of a part of text().
  [[nodiscard]] std::string original(std::string_view part) const;
  /// The column of the original, in code points from 1, for a line and column of text().
  [[nodiscard]] int column(int line, int column) const;

 private:
  void add(char32_t foreign, int line, std::size_t start_of_line);

  std::string mark_;  // before the number of a code point; occurs nowhere in the original
  std::string text_;
  std::vector<std::pair<int, int>> places_;  // line and column in text() of each code point that is written as a number
};

}  // namespace loadpath::toml
