#include "lib/toml/gate.hpp"

#include "lib/text/utf8.hpp"

#include <algorithm>

namespace loadpath::toml {

namespace {

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F;
}

bool is_foreign(char c) { return static_cast<unsigned char>(c) >= 0x80; }

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
  return next != std::string_view::npos && is_foreign(text[next]);
}

/// Behind the text in quotes that starts at `at`; npos where it is not closed.
std::size_t behind_quotes(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool long_text = text.substr(at, 3) == std::string(3, quote);
  const std::string_view closing = text.substr(at, long_text ? 3 : 1);
  for (std::size_t i = at + closing.size(); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text.substr(i, closing.size()) == closing) {
      return i + closing.size();
    } else if (!long_text && text[i] == '\n') {
      break;
    }
  }
  return std::string_view::npos;
}

/// The first character outside of quotes and comments for which `found` holds; npos where there is none, or a text
/// before it is not closed, which the parser tells. Of a comment its end alone is seen.
template <class Found>
std::size_t find_bare(std::string_view text, Found found) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  std::size_t i = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  while (i < text.size()) {
    if (text[i] == '"' || text[i] == '\'') {
      i = behind_quotes(text, i);
    } else if (text[i] == '#') {
      i = text.find('\n', i);
    } else if (found(text[i])) {
      return i;
    } else {
      ++i;
    }
  }
  return std::string_view::npos;
}

/// Where keys have more parts, or brackets lie deeper within one another, than any project has: the parser goes down by
/// a call for each.
std::size_t first_too_deep(std::string_view text) {
  constexpr int most = 64;
  int parts = 0, depth = 0;
  return find_bare(text, [&](char c) {
    if (c == '\n' || c == '=' || c == ',') parts = 0;
    if (c == '.') ++parts;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    return parts > most || depth > most;
  });
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

std::optional<Issue> refuse_bare(std::string_view text, const std::string& file) {
  if (const std::size_t deep = first_too_deep(text); deep != std::string_view::npos)
    return issue_at(text, deep, file, say("tables lie too deep within one another"), say("at most 64 levels"));
  const std::size_t at = find_bare(text, is_foreign);
  if (at == std::string_view::npos) return std::nullopt;
  return issue_at(text, at, file, say("not valid TOML: a character outside ASCII stands outside of quotes"), {});
}

}  // namespace loadpath::toml
