// Formulas without fractions, roots and tables as text of the math font: a third of the bytes of their MathML.
#include "lib/report/html/html.hpp"
#include "lib/text/utf8.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace loadpath::report::page {
namespace {

/// An element; its parts follow it in the list of all.
struct Item {
  std::string_view markup, name, attributes, content;
  std::size_t end = 0;  // the place behind its parts
};

/// Elements next to each other, from a place in the list on.
struct Row {
  std::string_view markup;
  std::size_t first = 0, end = 0;
};

/// All elements, each before its parts. Markup that is not closed ends with what was closed before it.
std::vector<Item> items_of(std::string_view markup) {
  std::vector<Item> items;
  std::vector<std::size_t> open;
  for (std::size_t at = markup.find('<'); at != std::string_view::npos; at = markup.find('<', at)) {
    const std::size_t end = markup.find('>', at);
    if (end == std::string_view::npos) break;
    const std::string_view tag = markup.substr(at + 1, end - at - 1);
    if (tag.starts_with('/')) {
      if (open.empty() || items[open.back()].name != tag.substr(1)) break;
      Item& item = items[open.back()];
      item.content = item.content.substr(0, at - static_cast<std::size_t>(item.content.data() - markup.data()));
      item.markup = item.markup.substr(0, end + 1 - static_cast<std::size_t>(item.markup.data() - markup.data()));
      item.end = items.size();
      open.pop_back();
    } else {
      const bool is_empty = tag.ends_with('/');
      const std::string_view inner = tag.substr(0, tag.size() - (is_empty ? 1 : 0));
      const std::string_view name = inner.substr(0, inner.find(' '));
      const std::size_t content = is_empty ? 0 : std::string_view::npos, whole = is_empty ? end + 1 - at : content;
      items.push_back({markup.substr(at, whole), name, inner.substr(name.size()), markup.substr(end + 1, content), 0});
      if (is_empty) items.back().end = items.size();
      if (!is_empty) open.push_back(items.size() - 1);
    }
    at = end + 1;
  }
  if (!open.empty()) items.resize(open.front());
  return items;
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

bool add_identifier(const Item& item, std::string& out) {
  const bool is_letter =
      item.attributes.empty() && !item.content.empty() && character_length(item.content, 0) == item.content.size();
  if (!is_letter) return out += item.content, true;
  const auto letter = slanted(code_points(item.content).front());
  if (letter) out += utf8(std::u32string_view(&*letter, 1));
  return letter.has_value();
}

/// Relations and binary operators have spaces; a sign, a comma of indices and the application of a function none. A
/// delimiter that is an operator grows with its content, as text does not.
bool add_operation(const Item& item, bool in_script, std::string& out) {
  constexpr std::string_view delimiters = "()|{";
  const std::string_view text = item.content;
  if (text.size() == 1 && delimiters.find(text) != std::string_view::npos) return false;
  if (text == "\u2061") return true;
  if (text == ",") {
    out += in_script ? "," : ",\u2009";
  } else if (in_script || item.attributes.find("prefix") != std::string_view::npos) {
    out += text;
  } else {
    out.append(" ").append(text).append(" ");
  }
  return true;
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

/// The markup of one formula.
class Markup {
 public:
  explicit Markup(std::string_view markup) : whole_{markup, 0, 0}, items_(items_of(markup)) {
    whole_.end = items_.size();
  }
  [[nodiscard]] Row whole() const { return whole_; }

  /// Adds the row as text; false if something of it is not text, with any part of it added.
  bool add_text(const Row& row, bool in_script, std::string& out) const {
    std::string_view rest = row.markup;
    for (std::size_t i = row.first; i < row.end; i = items_[i].end) {
      const Item& item = items_[i];
      if (item.markup.data() != rest.data() || !add_text(i, in_script, out)) return false;
      rest.remove_prefix(item.markup.size());
    }
    return rest.empty();
  }

  /// The elements of a row: neighbouring ones that are text as one text, if this is shorter.
  void add_shorter(const Row& row, std::string& out) const {
    std::string text;
    std::string_view written, rest = row.markup;  // the markup of the text
    const auto flush = [&] {
      const std::string element = written.empty() ? std::string() : as_element(std::exchange(text, {}));
      out += element.size() < written.size() ? element : written;
      written = {};
    };
    for (std::size_t i = row.first; i < row.end && items_[i].markup.data() == rest.data(); i = items_[i].end) {
      const std::string_view markup = items_[i].markup;
      rest.remove_prefix(markup.size());
      const std::size_t before = text.size();
      if (add_text(i, false, text)) {
        written = written.empty() ? markup : std::string_view(written.data(), written.size() + markup.size());
        continue;
      }
      text.resize(before);
      flush();
      add_shorter(i, out);
    }
    flush();
    out += rest;
  }

 private:
  [[nodiscard]] Row content_of(std::size_t i) const { return {items_[i].content, i + 1, items_[i].end}; }
  [[nodiscard]] Row only(std::size_t i) const { return {items_[i].markup, i, items_[i].end}; }

  bool add_text(std::size_t i, bool in_script, std::string& out) const {
    const Item& item = items_[i];
    if (item.name == "mi") return add_identifier(item, out);
    if (item.name == "mn" || item.name == "mtext") return out += item.content, true;
    if (item.name == "mo") return add_operation(item, in_script, out);
    if (item.name == "mspace") return out += "\u2009", true;
    if (item.name == "mrow") return add_text(content_of(i), in_script, out);
    if (item.name == "msub" || item.name == "msup") return !in_script && add_scripted(i, out);
    return false;
  }

  /// A base with a subscript or an exponent, neither of which has a script of its own.
  bool add_scripted(std::size_t i, std::string& out) const {
    const Item& item = items_[i];
    const std::size_t base = i + 1;
    if (base >= item.end || items_[base].markup.data() != item.content.data()) return false;
    if (!add_text(base, false, out)) return false;
    const std::string_view name = item.name == "msub" ? "sub" : "sup";
    out.append("<").append(name).append(">");
    const Row script{item.content.substr(items_[base].markup.size()), items_[base].end, item.end};
    if (!add_text(script, true, out)) return false;
    out.append("</").append(name).append(">");
    return true;
  }

  /// An element that is not text, with text in place of its parts where these are.
  void add_shorter(std::size_t i, std::string& out) const {
    const Item& item = items_[i];
    out.append("<").append(item.name).append(item.attributes).append(">");
    if (item.name == "mrow" || item.name == "msqrt" || item.name == "mtd") {
      add_shorter(content_of(i), out);
    } else {
      std::string_view rest = item.content;
      for (std::size_t part = i + 1; part < item.end && items_[part].markup.data() == rest.data();
           part = items_[part].end) {
        add_shorter(only(part), out);
        rest.remove_prefix(items_[part].markup.size());
      }
      out += rest;
    }
    out.append("</").append(item.name).append(">");
  }

  Row whole_;
  std::vector<Item> items_;
};

}  // namespace

std::string math(std::string_view fragment) {
  constexpr std::string_view equals = "<mo>=</mo>";
  std::string text = "<i>";
  const Markup markup(fragment);
  if (markup.add_text(markup.whole(), false, text)) {
    if (fragment.starts_with("<mo>=")) text.erase(3, 1);  // the space before the sign
    return text + "</i>";
  }
  const bool is_equation = fragment.starts_with(equals);
  std::string out = is_equation ? "= <math>" : "<math>";
  const Row all = markup.whole();
  markup.add_shorter(is_equation ? Row{all.markup.substr(equals.size()), 1, all.end} : all, out);
  return out + "</math>";
}

}  // namespace loadpath::report::page
