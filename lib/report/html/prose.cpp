// Symbols of running text: "K_A" with a subscript.
#include "lib/report/columns.hpp"
#include "lib/report/html/html.hpp"
#include "lib/text/markup.hpp"

#include <algorithm>

namespace loadpath::report::page {
namespace {

/// A letter, a digit, an underscore or a byte of a Greek letter.
bool is_of_symbol(char c) {
  const auto byte = static_cast<unsigned char>(c);
  const bool is_latin = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return is_latin || (c >= '0' && c <= '9') || c == '_' || byte == 0xCE || byte == 0xCF || (byte & 0xC0U) == 0x80U;
}

/// Whether it is the symbol of a quantity, "K_A" or "σ_adm": a name of the file, "left_seat", has a longer beginning.
bool is_indexed(std::string_view word) {
  constexpr double longest_base = 2.0;
  const std::size_t bar = word.find('_');
  if (bar == std::string_view::npos || bar == 0 || bar + 1 == word.size() || word.back() == '_') return false;
  return (word.front() < '0' || word.front() > '9') && letters_of(word.substr(0, bar)) <= longest_base;
}

/// Whether a slash in front of it belongs to a path, "sections/I_80": in "z_2/z_1" it divides two symbols.
bool is_in_path(std::string_view text, std::size_t begin) {
  if (begin < 2 || text[begin - 1] != '/') return false;
  constexpr double longest_unit = 3.0;  // "235 MPa/R_e"
  std::size_t first = begin - 1;
  while (first > 0 && is_of_symbol(text[first - 1])) --first;
  const std::string_view dividend = text.substr(first, begin - 1 - first);
  return !is_indexed(dividend) && letters_of(dividend) > longest_unit;
}

/// Whether the text has it as the user types it: in a path, or between quotes.
bool is_typed(std::string_view text, std::size_t begin, std::size_t end) {
  constexpr std::string_view before = ".\"'`", behind = "\"'`[";
  if (begin > 0 && before.find(text[begin - 1]) != std::string_view::npos) return true;
  if (is_in_path(text, begin)) return true;
  if (end == text.size()) return false;
  const bool is_path = text[end] == '.' && end + 1 < text.size() && is_of_symbol(text[end + 1]);
  return is_path || behind.find(text[end]) != std::string_view::npos;
}

std::string with_subscript(std::string_view word) {
  const std::size_t bar = word.find('_');
  std::string below(word.substr(bar + 1));
  std::ranges::replace(below, '_', ',');
  return escaped(word.substr(0, bar)) + "<sub>" + escaped(below) + "</sub>";
}

/// The end of a second index, a digit or letters without an index of their own; 0 of anything else.
std::size_t end_of_index(std::string_view text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && is_of_symbol(text[end])) ++end;
  const std::string_view index = text.substr(begin, end - begin);
  if (index.empty()) return 0;
  if (index.front() >= '0' && index.front() <= '9') return index.size() == 1 ? end : 0;
  return index.front() >= 'a' && index.front() <= 'z' && index.find('_') == std::string_view::npos ? end : 0;
}

/// The end of a word; the second index of "p_adm,1", of "x_d,k" and of "v_rim,adm" belongs to it.
std::size_t end_of_word(std::string_view text, std::size_t begin) {
  constexpr std::string_view negative = "_\u2212";  // of a fatigue limit, "σ_−1"
  std::size_t end = begin;
  while (end < text.size() && (is_of_symbol(text[end]) || (end > begin && text.substr(end - 1).starts_with(negative))))
    ++end;
  const bool has_comma = end + 1 < text.size() && text[end] == ',' && is_indexed(text.substr(begin, end - begin));
  return has_comma ? std::max(end, end_of_index(text, end + 1)) : end;
}

/// Whether it is the 2 of "s^2", between no quotes, where the user types it so.
bool is_exponent(std::string_view text, std::size_t begin, std::string_view word) {
  if (begin < 2 || text[begin - 1] != '^' || text.find('"') != std::string_view::npos) return false;
  return word.size() == 1 && word.front() >= '2' && word.front() <= '9';
}

}  // namespace

std::string prose(std::string_view text) {
  if (text.find_first_of("_^") == std::string_view::npos) return escaped(text);
  std::string out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = end_of_word(text, begin);
    const std::string_view word = text.substr(begin, end - begin);
    if (is_exponent(text, begin, word)) {
      out.back() = '<';  // in place of the circumflex
      out += "sup>" + std::string(word) + "</sup>";
    } else {
      out += is_indexed(word) && !is_typed(text, begin, end) ? with_subscript(word) : escaped(word);
    }
    begin = end;
    std::size_t next = begin;
    while (next < text.size() && !is_of_symbol(text[next])) ++next;
    out += escaped(text.substr(begin, next - begin));
    begin = next;
  }
  return out;
}

}  // namespace loadpath::report::page
