// A text that is open in an editor. Editors count lines from 0 and columns in units of UTF-16; the program counts
// bytes, and in its messages code points from 1.
#pragma once

#include "lib/text/issue.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::cli::lsp {

struct Position {
  std::size_t line = 0, character = 0;
};

struct Range {
  Position start, end;
};

class Document {
 public:
  explicit Document(std::string text = {});

  [[nodiscard]] const std::string& text() const { return text_; }
  /// The byte at a position; one beyond a line is its end, one beyond the text that of the text.
  [[nodiscard]] std::size_t offset_of(const Position& position) const;
  [[nodiscard]] std::size_t offset_of(const Place& place) const;
  [[nodiscard]] Position position_of(std::size_t offset) const;
  [[nodiscard]] Range range_of(std::size_t begin, std::size_t end) const {
    return {position_of(begin), position_of(end)};
  }
  [[nodiscard]] Range range_of(const Place& place) const;
  /// Puts a text in the place of a range.
  void change(const Range& range, std::string_view text);

 private:
  void find_lines();
  /// The line without its end.
  [[nodiscard]] std::string_view line(std::size_t number) const;

  std::string text_;
  std::vector<std::size_t> starts_;  // offsets of lines
};

}  // namespace loadpath::cli::lsp
