#include "lib/toml/gate.hpp"

#include "lib/text/utf8.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace loadpath::toml {

namespace {

bool is_foreign(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// "U+0007"
std::string code_of(std::string_view text, std::size_t at) {
  constexpr char digits[] = "0123456789ABCDEF";
  const char32_t point = code_points(text.substr(at, character_length(text, at)))[0];
  return std::string("U+00") + digits[(point >> 4U) & 0x0FU] + digits[point & 0x0FU];
}

/// Behind the text in quotes that starts at `at`; npos if it is not closed.
std::size_t behind_quotes(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool long_text = text.substr(at, 3) == std::string(3, quote);
  const std::string_view closing = text.substr(at, long_text ? 3 : 1);
  for (std::size_t i = at + closing.size(); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text.substr(i, closing.size()) == closing) {
      std::size_t end = i + closing.size();
      for (int more = 0; long_text && more < 2 && end < text.size() && text[end] == quote; ++more) ++end;
      return end;
    } else if (!long_text && text[i] == '\n') {
      break;
    }
  }
  return std::string_view::npos;
}

/// Whether a quote opens a text, or is glued to a bare word: the parser reads that word on, quote and all.
class Openings {
 public:
  /// Called for every bare character.
  void pass(char c) {
    if (c == '{' || c == '[') return open(c);
    if ((c == '}' || c == ']') && !brackets_.empty()) brackets_.pop_back();
    opens_ = c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',' || (!in_value_ && (c == '=' || c == '.'));
    if (c == '=') in_value_ = true;
    if (c == ',' && brackets_.ends_with('{')) in_value_ = false;
    if (c == '\n' && brackets_.empty()) in_value_ = false;
  }
  void pass_text() { opens_ = false; }
  [[nodiscard]] bool opens() const { return opens_; }

 private:
  /// A bracket that is glued to a word opens as little as a quote there.
  void open(char bracket) {
    brackets_ += bracket;
    if (bracket == '{') in_value_ = false;
  }

  std::string brackets_;  // open ones
  bool in_value_ = false;
  bool opens_ = true;
};

/// The first character outside of quotes and comments for which `found` holds; npos if there is none, or a text
/// before it is not closed, which the parser reports. Comments are skipped up to their end.
template <class Found>
std::size_t find_bare(std::string_view text, Found found) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  std::size_t i = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  Openings openings;
  while (i < text.size()) {
    if ((text[i] == '"' || text[i] == '\'') && openings.opens()) {
      i = behind_quotes(text, i);
      openings.pass_text();
    } else if (text[i] == '#') {
      i = text.find('\n', i);
    } else if (found(text[i])) {
      return i;
    } else {
      openings.pass(text[i++]);
    }
  }
  return std::string_view::npos;
}

/// The first place with more parts of a key, or deeper nested brackets, than any project has: the parser recurses for
/// each.
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
  if (const std::size_t at = first_control(text, "\t\n\r"); at != std::string_view::npos)
    return issue_at(text, at, file, say("control character {1}", code_of(text, at)),
                    say("remove it; a project is a text file"));
  return std::nullopt;
}

std::optional<Issue> refuse_bare(std::string_view text, const std::string& file) {
  if (const std::size_t deep = first_too_deep(text); deep != std::string_view::npos)
    return issue_at(text, deep, file, say("tables are nested too deep"), say("at most 64 levels"));
  if (const std::size_t at = find_bare(text, is_foreign); at != std::string_view::npos)
    return issue_at(text, at, file, say("not valid TOML: non-ASCII character outside quotes"), {});
  return std::nullopt;
}

}  // namespace loadpath::toml
