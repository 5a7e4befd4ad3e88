// Formulas without fractions, roots and tables as text of the math font: a third of the bytes of their MathML.
#include "lib/report/html/html.hpp"
#include "lib/text/utf8.hpp"

#include <optional>
#include <utility>

namespace loadpath::report::page {
namespace {

struct Item {
  std::string_view name, attributes, content;
};

/// The first element of the markup, which is removed from it; nothing of text that is not in an element.
std::optional<Item> next_item(std::string_view& markup) {
  const std::size_t end = markup.find('>');
  if (!markup.starts_with('<') || end == std::string_view::npos) return std::nullopt;
  const bool is_empty = markup[end - 1] == '/';
  const std::string_view tag = markup.substr(1, end - 1 - (is_empty ? 1 : 0));
  const std::string_view name = tag.substr(0, tag.find(' '));
  Item item{name, tag.substr(name.size()), {}};
  markup.remove_prefix(end + 1);
  if (is_empty) return item;
  int depth = 1;
  for (std::size_t at = markup.find('<'); at != std::string_view::npos; at = markup.find('<', at + 1)) {
    const bool closes = markup.substr(at + 1, 1) == "/";
    const std::size_t begin = at + (closes ? 2 : 1), behind = begin + name.size();
    if (behind >= markup.size() || (markup[behind] != '>' && markup[behind] != ' ')) continue;
    if (markup.substr(begin, name.size()) != name) continue;
    depth += closes ? -1 : 1;
    if (depth > 0) continue;
    item.content = markup.substr(0, at);
    markup.remove_prefix(behind + 1);
    return item;
  }
  return std::nullopt;
}

/// The slanted letter that browsers set for an identifier of one letter; nothing for other characters.
std::optional<char32_t> slanted(char32_t letter) {
  if (letter == U'h') return U'\u210E';
  if (U'A' <= letter && letter <= U'Z') return letter - U'A' + 0x1D434;
  if (U'a' <= letter && letter <= U'z') return letter - U'a' + 0x1D44E;
  if (U'\u0391' <= letter && letter <= U'\u03A9') return letter - U'\u0391' + 0x1D6E2;
  if (U'\u03B1' <= letter && letter <= U'\u03C9') return letter - U'\u03B1' + 0x1D6FC;
  return std::nullopt;
}

std::optional<std::string> identifier(const Item& item) {
  const std::u32string letters = code_points(item.content);
  if (letters.size() != 1 || !item.attributes.empty()) return std::string(item.content);
  const auto letter = slanted(letters.front());
  return letter ? std::optional(utf8(std::u32string(1, *letter))) : std::nullopt;
}

/// Relations and binary operators have spaces; a sign, a comma of indices and the application of a function none. A
/// delimiter that is an operator grows with its content, as text does not.
std::optional<std::string> operation(const Item& item, bool in_script) {
  constexpr std::string_view delimiters = "()|{";
  const std::string text(item.content);
  if (text.size() == 1 && delimiters.find(text) != std::string_view::npos) return std::nullopt;
  if (text == "\u2061") return "";
  if (text == ",") return in_script ? "," : ",\u2009";
  return in_script || item.attributes.find("prefix") != std::string_view::npos ? text : " " + text + " ";
}

std::optional<std::string> text_of(std::string_view markup, bool in_script);

/// A base with a subscript or an exponent, neither of which has a script of its own.
std::optional<std::string> scripted(const Item& item, bool in_script) {
  std::string_view rest = item.content;
  const std::string_view whole = rest;
  if (in_script || !next_item(rest)) return std::nullopt;
  const auto base = text_of(whole.substr(0, whole.size() - rest.size()), false), script = text_of(rest, true);
  if (!base || !script) return std::nullopt;
  const std::string name = item.name == "msub" ? "sub" : "sup";
  return *base + "<" + name + ">" + *script + "</" + name + ">";
}

std::optional<std::string> text_of(const Item& item, bool in_script) {
  if (item.name == "mi") return identifier(item);
  if (item.name == "mn" || item.name == "mtext") return std::string(item.content);
  if (item.name == "mo") return operation(item, in_script);
  if (item.name == "mspace") return "\u2009";
  if (item.name == "mrow") return text_of(item.content, in_script);
  if (item.name == "msub" || item.name == "msup") return scripted(item, in_script);
  return std::nullopt;
}

std::optional<std::string> text_of(std::string_view markup, bool in_script) {
  std::string out;
  while (!markup.empty()) {
    const auto item = next_item(markup);
    const auto text = item ? text_of(*item, in_script) : std::nullopt;
    if (!text) return std::nullopt;
    out += *text;
  }
  return out;
}

/// Text in a formula keeps the blanks at its ends. It is set as numbers are: next to mtext an operator is
/// set as a sign. Scripts directly in a token would be blocks.
std::string as_element(std::string text) {
  constexpr std::string_view kept_blank = "\u00A0";
  if (text.ends_with(' ')) text.replace(text.size() - 1, 1, kept_blank);
  if (text.starts_with(' ')) text.replace(0, 1, kept_blank);
  const bool has_scripts = text.find('<') != std::string::npos;
  return has_scripts ? "<mn><i>" + text + "</i></mn>" : "<mn>" + text + "</mn>";
}

std::string shorter_row(std::string_view markup);

/// An element that is not text, with text in place of its parts where these are.
std::string shorter(const Item& item) {
  const bool is_row = item.name == "mrow" || item.name == "msqrt" || item.name == "mtd";
  std::string inner;
  std::string_view rest = item.content;
  while (!is_row && rest.starts_with('<')) {
    const std::string_view before = rest;
    if (!next_item(rest)) break;
    inner += shorter_row(before.substr(0, before.size() - rest.size()));
  }
  inner += is_row ? shorter_row(rest) : std::string(rest);
  const std::string name(item.name);
  return "<" + name + std::string(item.attributes) + ">" + inner + "</" + name + ">";
}

/// The elements of a row: neighbouring ones that are text as one text, if this is shorter.
std::string shorter_row(std::string_view markup) {
  std::string out, text;
  std::string_view written;  // the markup of the text
  const auto flush = [&] {
    const std::string element = written.empty() ? std::string() : as_element(std::exchange(text, {}));
    out += element.size() < written.size() ? element : std::string(written);
    written = {};
  };
  while (!markup.empty()) {
    const std::string_view before = markup;
    const auto item = next_item(markup);
    if (!item) return out.append(written).append(before);
    const std::string_view whole = before.substr(0, before.size() - markup.size());
    if (const auto line = text_of(*item, false)) {
      text += *line;
      written = written.empty() ? whole : std::string_view(written.data(), written.size() + whole.size());
    } else {
      flush();
      out += shorter(*item);
    }
  }
  flush();
  return out;
}

}  // namespace

std::string math(std::string_view fragment) {
  constexpr std::string_view equals = "<mo>=</mo>";
  auto text = text_of(fragment, false);
  if (!text) {
    const bool is_equation = fragment.starts_with(equals);
    if (is_equation) fragment.remove_prefix(equals.size());
    return (is_equation ? "= <math>" : "<math>") + shorter_row(fragment) + "</math>";
  }
  if (text->starts_with(' ') && fragment.starts_with("<mo>=")) text->erase(0, 1);
  return "<i>" + *text + "</i>";
}

}  // namespace loadpath::report::page
