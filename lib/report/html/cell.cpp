#include "lib/account/conclusion.hpp"
#include "lib/formula/formula.hpp"
#include "lib/report/html/html.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/worked.hpp"
#include "lib/text/markup.hpp"

#include <algorithm>
#include <array>

namespace loadpath::report::page {
namespace {

std::string with_kept_blanks(std::string text) {
  constexpr std::string_view kept_blank = "\u00A0";
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at))
    text.replace(at, 1, kept_blank);
  return text;
}

/// A number and its unit are not broken between lines; a browser may break behind a solidus. A number with a power of
/// ten is long: it may be broken in front of its unit, "5.696 · 10⁷ mm⁴".
std::string kept(const std::string& quantity) {
  constexpr std::string_view power = " \u00B7 10", begin = "<span class=\"quantity\">", end = "</span>";
  std::string text = page::quantity(quantity);
  if (text.find(' ') == std::string::npos) return text;
  if (quantity.find('/') != std::string::npos) return std::string(begin).append(text).append(end);
  const std::size_t ten = text.find(power), unit = text.rfind(' ');
  if (ten == std::string::npos || unit < ten + power.size()) return with_kept_blanks(std::move(text));
  return with_kept_blanks(text.substr(0, unit)).append(" ").append(begin).append(text, unit + 1).append(end);
}

/// An expression may break behind the dots of its paths: "= intermediate.bearings.left.F_r" in a narrow column.
std::string breakable(const std::string& text) {
  if (!text.starts_with('=')) return prose(text);
  const auto is_letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; };
  std::string out;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find('.', begin);
    while (end != std::string::npos && (end + 1 == text.size() || !is_letter(text[end + 1])))
      end = text.find('.', end + 1);
    end = end == std::string::npos ? text.size() : end + 1;
    out += escaped(text.substr(begin, end - begin)) + (end < text.size() ? "<wbr>" : "");
    begin = end;
  }
  return out;
}

struct CellText {
  std::string operator()(const std::string& text) const { return breakable(text); }
  std::string operator()(const Message& message) const { return breakable(message.text()); }
  std::string operator()(const Quantity& q) const { return kept(formula::quantity_plain(written(q))); }
  std::string operator()(const Symbol& s) const { return symbol(s.name); }
  std::string operator()(State s) const { return state(s); }
  std::string operator()(const Utilisation& u) const { return kept(utilisation_text(u.value)) + bar(u.value); }
  std::string operator()(const Sized& s) const {
    return "<b class=\"sized\">" + prose(s.text) + "*</b>" + prose(s.behind());
  }
};

}  // namespace

std::string symbol(std::string_view path) {
  const NamedSymbol named = named_symbol(path);
  const std::string where = named.where.empty() ? "" : "<span class=\"where\">" + escaped(named.where) + "</span> ";
  if (is_word(named.symbol)) return where + escaped(named.symbol);
  const std::string shown = formula::symbol_html(named.symbol);
  return where + (shown.starts_with("<math>") ? shown : "<i>" + shown + "</i>");
}

std::string quantity(std::string_view text) {
  constexpr std::string_view minus = "⁻";
  constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::string whole = escaped(text);
  std::string out;
  for (std::string_view rest = whole; !rest.empty();) {
    const std::size_t at = std::min(rest.find(minus), rest.size());
    out += rest.substr(0, at);
    rest.remove_prefix(at);
    if (rest.empty()) break;
    rest.remove_prefix(minus.size());
    out += "<sup>−";
    const auto begins = [&](std::string_view digit) { return rest.starts_with(digit); };
    for (auto d = std::ranges::find_if(digits, begins); d != digits.end(); d = std::ranges::find_if(digits, begins)) {
      out += static_cast<char>('0' + (d - digits.begin()));
      rest.remove_prefix(d->size());
    }
    out += "</sup>";
  }
  return out;
}

std::string cell(const Cell& cell) { return std::visit(CellText{}, cell); }

namespace {

/// The style sheet sets the mark of the state in front of the words.
std::string marked(State state, const std::string& words) {
  const std::string name = slug(state);
  return "<span class=\"state " + name + "\">" + escaped(words) + "</span>";
}

}  // namespace

std::string state(State state) { return marked(state, account::shown(state).text()); }

std::string state_cell(State state, const std::string& words) {
  return "<td class=\"state " + std::string(slug(state)) + "\">" + escaped(words) + "</td>";
}

std::string headline(const Modes& modes) {
  return marked(account::overall(modes), account::word(account::conclude(modes).headline));
}

}  // namespace loadpath::report::page
