#include "lib/toml/gate.hpp"

#include "lib/text/utf8.hpp"

#include <algorithm>

namespace loadpath::toml {

namespace {

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F;
}

/// "U+0007"
std::string code_of(char c) {
  constexpr char digits[] = "0123456789ABCDEF";
  const auto byte = static_cast<unsigned char>(c);
  return std::string("U+00") + digits[byte >> 4U] + digits[byte & 0x0FU];
}

/// Whether the backslash at `at` ends its line and the next text begins with a letter outside ASCII.
bool continues_outside_ascii(std::string_view text, std::size_t at) {
  const std::size_t end = text.find_first_not_of(" \t\r", at + 1);
  if (end == std::string_view::npos || text[end] != '\n') return false;
  const std::size_t next = text.find_first_not_of(" \t\r\n", end);
  return next != std::string_view::npos && static_cast<unsigned char>(text[next]) >= 0x80;
}

Issue issue_at(std::string_view text, std::size_t at, const std::string& file, Message message, Message hint) {
  const std::string_view before = text.substr(0, at);
  const std::size_t start = before.rfind('\n') + 1;  // npos + 1 is 0
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t column = 1 + code_points(before.substr(start)).size();
  return {{file, static_cast<int>(line), static_cast<int>(column), 1},
          "",
          std::move(message),
          std::move(hint),
          Severity::error};
}

}  // namespace

std::optional<Issue> refuse_text(std::string_view text, const std::string& file) {
  if (text.size() > largest_file)
    return Issue{{file, 0, 0, 1}, "", say("the file is larger than 4 MiB"), {}, Severity::error};
  if (const std::size_t at = first_invalid_byte(text); at != std::string_view::npos) {
    return issue_at(text, at, file, say("this byte is not UTF-8"), say("save the file as UTF-8"));
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_control(text[i]))
      return issue_at(text, i, file, say("the control character {1}", code_of(text[i])), say("remove it"));
    if (text[i] != '\\') continue;
    if (continues_outside_ascii(text, i)) {
      return issue_at(text, i, file, say("a backslash at the end of a line before a letter outside ASCII"),
                      say("write the text in one line"));
    }
    if (i + 1 < text.size() && text[i + 1] == '\\') ++i;  // an escaped backslash escapes nothing
  }
  return std::nullopt;
}

}  // namespace loadpath::toml
