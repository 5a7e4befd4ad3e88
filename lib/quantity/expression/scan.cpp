#include "lib/quantity/expression/scan.hpp"

#include "lib/quantity/expression/tree.hpp"

#include <algorithm>
#include <span>

namespace loadpath::expression {
namespace {

using Symbols = std::span<const std::string_view>;

constexpr std::string_view spaces[] = {" ", "\t", "\n", "\r", "\u00A0", "\u2009", "\u202F"};
constexpr std::string_view times[] = {"*", "·", "⋅"};
constexpr std::string_view joiners[] = {"*", "·", "⋅", "/"};
constexpr std::string_view minuses[] = {"-", "−"};
constexpr std::string_view signs[] = {"-", "−", "+"};
constexpr std::string_view superscripts[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹", "⁻", "⁺"};
constexpr std::string_view no_letters[] = {"×", "÷", "√", "∙"};

std::size_t symbol_end(std::string_view text, std::size_t at, Symbols symbols) {
  const auto rest = text.substr(std::min(at, text.size()));
  for (const auto symbol : symbols) {
    if (rest.starts_with(symbol)) return at + symbol.size();
  }
  return at;
}

std::size_t repeated_end(std::string_view text, std::size_t at, Symbols symbols) {
  for (auto end = symbol_end(text, at, symbols); end != at; end = symbol_end(text, at, symbols)) at = end;
  return at;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_foreign(char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; }

char character(std::string_view text, std::size_t at) { return at < text.size() ? text[at] : '\0'; }

bool is_symbol(std::string_view text, std::size_t at) {
  for (const Symbols symbols :
       {Symbols{spaces}, Symbols{joiners}, Symbols{minuses}, Symbols{superscripts}, Symbols{no_letters}}) {
    if (symbol_end(text, at, symbols) != at) return true;
  }
  return false;
}

/// [12] behind a name.
std::size_t index_end(std::string_view text, std::size_t at) {
  if (character(text, at) != '[') return at;
  const auto end = digits_end(text, at + 1);
  return end > at + 1 && character(text, end) == ']' ? end + 1 : at;
}

/// "IPE 330": the name of a row of a table, in quotes.
std::size_t quoted_end(std::string_view text, std::size_t at) {
  if (character(text, at) != '"') return at;
  const auto close = text.find('"', at + 1);
  return close == std::string_view::npos || close == at + 1 ? at : close + 1;
}

/// A dot and a name behind it, with its index, or one in quotes.
std::size_t part_end(std::string_view text, std::size_t at) {
  if (character(text, at) != '.') return at;
  if (is_letter(character(text, at + 1))) return index_end(text, name_end(text, at + 1));
  const auto end = quoted_end(text, at + 1);
  return end == at + 1 ? at : end;
}

/// The text searched for a unit, and the words excluded.
struct Units {
  std::string_view text;
  Names variables;
};

/// A word that cannot be a reference, a call, the constant pi or a variable. `30 MPa (2)` needs an operator, `2 cos
/// (x)` is a call.
bool is_bare(const Units& in, std::size_t at, std::size_t end) {
  const auto text = in.text;
  const auto word = text.substr(at, end - at);
  const bool dotted = character(text, end) == '.' && is_letter(character(text, end + 1));
  const bool called =
      character(text, end) == '(' || (character(text, skip_space(text, end)) == '(' && find_function(word) != nullptr);
  return !word.empty() && !dotted && !called && character(text, end) != '[' && word != "pi" &&
         !is_among(in.variables, word);
}

std::size_t exponent_end(std::string_view text, std::size_t at) {
  at = repeated_end(text, at, superscripts);
  const auto caret = skip_space(text, at);
  if (character(text, caret) != '^') return at;
  const auto exponent = skip_space(text, caret + 1);
  if (character(text, exponent) == '(') return std::min(text.find(')', exponent), text.size() - 1) + 1;
  const auto whole = digits_end(text, symbol_end(text, exponent, signs));
  return character(text, whole) == '.' ? digits_end(text, whole + 1) : whole;
}

std::size_t divisor_end(const Units& in, std::size_t at);

std::size_t factor_end(const Units& in, std::size_t at) {
  const auto word = word_end(in.text, at);
  return is_bare(in, at, word) ? exponent_end(in.text, word) : at;
}

/// A joiner and the joined part.
std::size_t joined_end(const Units& in, std::size_t at, Symbols by) {
  const auto joiner = skip_space(in.text, at);
  const auto behind = symbol_end(in.text, joiner, by);
  if (behind == joiner) return at;
  const auto factor = skip_space(in.text, behind);
  const auto end = in.text[joiner] == '/' ? divisor_end(in, factor) : factor_end(in, factor);
  return end == factor ? at : end;
}

std::size_t product_end(const Units& in, std::size_t at, Symbols by) {
  for (auto next = joined_end(in, at, by); next != at; next = joined_end(in, at, by)) at = next;
  return at;
}

/// A factor or a product of words in parentheses: W/(m*K). A single word in them is left to the expression: N/(g).
std::size_t divisor_end(const Units& in, std::size_t at) {
  if (character(in.text, at) != '(') return factor_end(in, at);
  const auto inside = skip_space(in.text, at + 1);
  const auto first = factor_end(in, inside);
  if (first == inside) return at;
  const auto last = product_end(in, first, Symbols{times});
  const auto close = skip_space(in.text, last);
  return last != first && character(in.text, close) == ')' ? exponent_end(in.text, close + 1) : at;
}

/// `1/` and a word.
std::size_t reciprocal_end(const Units& in, std::size_t at) {
  if (character(in.text, at) != '1') return at;
  const auto end = joined_end(in, at + 1, Symbols{joiners}.last(1));
  return end == at + 1 ? at : end;
}

}  // namespace

bool is_among(Names names, std::string_view word) { return std::ranges::find(names, word) != names.end(); }

std::size_t skip_space(std::string_view text, std::size_t at) { return repeated_end(text, at, spaces); }

std::size_t digits_end(std::string_view text, std::size_t at) {
  while (is_digit(character(text, at))) ++at;
  return at;
}

std::size_t times_end(std::string_view text, std::size_t at) { return symbol_end(text, at, times); }

std::size_t minus_end(std::string_view text, std::size_t at) { return symbol_end(text, at, minuses); }

std::size_t character_end(std::string_view text, std::size_t at) {
  if (at >= text.size()) return at;
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  for (++at; at < text.size() && continues(text[at]);) ++at;
  return at;
}

std::size_t name_end(std::string_view text, std::size_t at) {
  if (!is_letter(character(text, at))) return at;
  while (is_letter(character(text, at)) || is_digit(character(text, at))) ++at;
  return at;
}

std::size_t path_end(std::string_view text, std::size_t at) {
  auto end = index_end(text, name_end(text, at));
  if (end == at) return at;
  auto next = part_end(text, end);
  const bool dotted = next != end;
  for (; next != end; next = part_end(text, end)) end = next;
  return dotted ? end : at;
}

std::size_t word_end(std::string_view text, std::size_t at) {
  const auto begins = [text](std::size_t i) {
    const char c = character(text, i);
    return is_letter(c) || c == '%' || (is_foreign(c) && !is_symbol(text, i));
  };
  if (!begins(at)) return at;
  while (begins(at) || is_digit(character(text, at))) at = character_end(text, at);
  return at;
}

std::size_t unit_end(std::string_view text, std::size_t at, Names variables) {
  const Units in{text, variables};
  auto end = factor_end(in, at);
  if (end == at) end = reciprocal_end(in, at);
  return end == at ? at : product_end(in, end, joiners);
}

}  // namespace loadpath::expression
