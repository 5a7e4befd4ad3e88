#include "lib/io/text_gate.hpp"

namespace loadpath::io {

namespace {

unsigned char byte(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// The position behind a backslash at the end of a line and the white space after it; 0 where there is none.
std::size_t after_line_ending_backslash(std::string_view text) {
  std::size_t i = text.find_first_not_of(" \t\r", 1);
  if (i == std::string_view::npos || text[i] != '\n') return 0;
  i = text.find_first_not_of(" \t\r\n", i);
  return i == std::string_view::npos ? 0 : i;
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  const unsigned char first = byte(text, 0);
  const std::size_t length = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(text, i) & 0xC0U) != 0x80U) return 0;
  }
  const unsigned char second = length > 1 ? byte(text, 1) : 0;
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  const bool beyond = first == 0xF4 && second >= 0x90;
  return overlong || surrogate || beyond ? 0 : length;
}

std::optional<Issue> refuse_text(std::string_view text, const std::string& file) {
  if (text.size() > largest_file) return Issue{{file, 0, 0, 1}, "", say("the file is larger than 4 MiB"), {}, Severity::error};
  int line = 1, column = 1;
  for (std::size_t i = 0; i < text.size(); ++column) {
    const auto refuse = [&](Message message, Message hint = {}) {
      return Issue{{file, line, column, 1}, "", std::move(message), std::move(hint), Severity::error};
    };
    const std::size_t length = utf8_length(text.substr(i));
    if (length == 0) return refuse(say("this byte is not UTF-8"), say("save the file as UTF-8"));
    const char c = text[i];
    if ((byte(text, i) < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7F) return refuse(say("a control character"));
    if (c == '\\') {
      const std::size_t next = after_line_ending_backslash(text.substr(i));
      if (next != 0 && byte(text, i + next) >= 0x80) {
        return refuse(say("a backslash at the end of a line before a letter outside ASCII"), say("write the text in one line"));
      }
    }
    if (c == '\n') {
      ++line;
      column = 0;
    }
    i += length;
  }
  return std::nullopt;
}

}  // namespace loadpath::io
