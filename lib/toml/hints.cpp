#include "lib/toml/hints.hpp"

#include "lib/text/utf8.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace loadpath::toml {

namespace {

bool has_foreign(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

std::string_view without_blanks(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// The text with straight quotes in place of typographic ones that are not within straight ones; empty if it has none.
std::string with_straight_quotes(std::string_view text) {
  constexpr std::array<std::string_view, 8> quotes{"\u201C", "\u201D", "\u201E", "\u201F",
                                                   "\u2018", "\u2019", "\u00AB", "\u00BB"};
  std::string straight;
  bool within = false, is_changed = false;
  for (std::size_t i = 0; i < text.size();) {
    const auto quote = std::find_if(quotes.begin(), quotes.end(),
                                    [&](std::string_view one) { return text.substr(i).starts_with(one); });
    if (quote != quotes.end() && !within) {
      straight += '"';
      i += quote->size();
      is_changed = true;
      continue;
    }
    if (text[i] == '"') within = !within;
    straight += text[i++];
  }
  return is_changed ? straight : "";
}

/// Of the name of a table: [left, [Left bearing], [вал].
Message hint_for_name(std::string_view line) {
  if (has_foreign(line.substr(0, line.find(']')))) return say("a name has Latin letters, digits and '_'");
  const std::string_view open = without_blanks(line.substr(0, line.find('#')));
  const std::size_t end = open.find(']');
  std::string name(without_blanks(open.substr(1, end == std::string_view::npos ? end : end - 1)));
  const bool is_plain = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == ' ' || c == '-';
  });
  if (!is_plain || std::isalpha(static_cast<unsigned char>(name[0])) == 0) return {};
  std::replace(name.begin(), name.end(), ' ', '_');
  return say("write [{1}]", name);
}

/// Of a value that is not a number: a comment after it, or a quantity without its quotes.
Message hint_for_bare(std::string_view value) {
  const std::size_t comment = std::min(value.find(';'), value.find("//"));
  if (comment == std::string_view::npos) return say("write a quantity in quotes: \"{1}\"", value);
  std::string_view rest = value.substr(comment);
  rest.remove_prefix(std::min(rest.find_first_not_of(";/"), rest.size()));
  return say("a comment begins with '#': {1} # {2}", without_blanks(value.substr(0, comment)), without_blanks(rest));
}

/// Of a word without quotes: auto, ?.
Message hint_for_word(std::string_view line, int column) {
  const std::u32string letters = code_points(line);
  if (column < 1 || static_cast<std::size_t>(column) > letters.size()) return {};
  const auto at = static_cast<std::size_t>(column - 1);
  if (letters[at] == U'?') return say("a value to be found is written in quotes: \"?\"");
  std::size_t end = at;
  const auto is_of_word = [](char32_t c) {
    return c < 0x80 && (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == U'.' || c == U'_' || c == U'-');
  };
  while (end < letters.size() && is_of_word(letters[end])) ++end;
  const std::string word = utf8(letters.substr(at, end - at));
  if (word.empty() || std::isalpha(static_cast<unsigned char>(word[0])) == 0) return {};
  if (word == "auto") return say("a value to be found is written \"?\"");
  return say("write a text in quotes: \"{1}\"", word);
}

/// Whether a text in quotes is followed by ';', perhaps with a second key.
bool ends_with_semicolon(std::string_view value) {
  if (!value.starts_with('"') && !value.starts_with('\'')) return false;
  const std::size_t closed = value.find(value[0], 1);
  return closed != std::string_view::npos && without_blanks(value.substr(closed + 1)).starts_with(';');
}

}  // namespace

Message hint_for_brackets(std::string_view what, std::string_view line) {
  const auto says = [what](std::string_view words) { return what.find(words) != std::string_view::npos; };
  if (says("expected key or closing '}'") && says("saw '\\n'"))
    return say(
        "a table in braces is written on one line, { a = 1, b = 2 }; longer ones as [[step.list]] with a line "
        "for each key");
  if (says("dangling comma")) return say("remove the comma before '}'");
  if (says("expected comma or closing ']'")) return say("separate the elements of a list by commas");
  if (says("expected '='") && says("saw ':'")) return say("write '=' between key and value");
  if (says("determine value type") && line.starts_with('[') && without_blanks(line).ends_with(']'))
    return say("a list before this line is not closed: add ']'");
  return {};
}

Message hint_for(std::string_view line, int column) {
  const std::size_t equals = line.find('=');
  if (line.starts_with('[')) {
    if (Message hint = hint_for_name(line); !hint.empty()) return hint;
  }
  if (equals == std::string_view::npos) return {};
  const std::string_view value = without_blanks(line.substr(equals + 1)),
                         head = without_blanks(value.substr(0, value.find('#')));
  if (std::string straight = with_straight_quotes(head); !straight.empty())
    return say("these are typographic quotes: write {1}", straight);
  const bool bare = !head.empty() && head.find_first_of("\"'{[") == std::string_view::npos &&
                    (std::isdigit(static_cast<unsigned char>(head[0])) != 0 || head[0] == '-' || head[0] == '+');
  if (bare) return hint_for_bare(head);
  const bool quotes_within = head.starts_with("\"=") && head.find(".\"") != std::string_view::npos;
  if (quotes_within && head.size() > 2)
    return say("put an expression that contains quotes in single quotes: '{1}'", head.substr(1, head.size() - 2));
  const std::string_view key = line.substr(0, equals);
  if (ends_with_semicolon(head)) return say("leave out ';': each key has a line of its own");
  if (has_foreign(key) && key.find('"') == std::string_view::npos)
    return say("put a key with non-Latin letters in quotes");
  return hint_for_word(line, column);
}

}  // namespace loadpath::toml
