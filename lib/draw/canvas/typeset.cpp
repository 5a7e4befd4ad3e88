#include "lib/draw/canvas/typeset.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace loadpath::draw {
namespace {

using Face = Run::Face;

constexpr char mark_open = '\x0e', mark_close = '\x0f';  // no text of a user holds control characters

constexpr std::array<std::pair<std::string_view, std::string_view>, 37> greek{{
    {"alpha", "α"},   {"beta", "β"},  {"gamma", "γ"},  {"delta", "δ"}, {"epsilon", "ε"}, {"zeta", "ζ"},
    {"eta", "η"},     {"theta", "θ"}, {"iota", "ι"},   {"kappa", "κ"}, {"lambda", "λ"},  {"mu", "μ"},
    {"nu", "ν"},      {"xi", "ξ"},    {"pi", "π"},     {"rho", "ρ"},   {"sigma", "σ"},   {"tau", "τ"},
    {"upsilon", "υ"}, {"phi", "φ"},   {"chi", "χ"},    {"psi", "ψ"},   {"omega", "ω"},   {"Gamma", "Γ"},
    {"Delta", "Δ"},   {"Theta", "Θ"}, {"Lambda", "Λ"}, {"Xi", "Ξ"},    {"Pi", "Π"},      {"Sigma", "Σ"},
    {"Upsilon", "Υ"}, {"Phi", "Φ"},   {"Psi", "Ψ"},    {"Omega", "Ω"}, {"varphi", "φ"},  {"vartheta", "ϑ"},
    {"ell", "ℓ"},
}};

std::string_view greek_letter(std::string_view name) {
  const auto* found = std::find_if(greek.begin(), greek.end(), [&](const auto& entry) { return entry.first == name; });
  return found == greek.end() ? std::string_view{} : found->second;
}

bool is_latin(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name(std::string_view word) {
  return !word.empty() && is_latin(word.front()) &&
         std::all_of(word.begin(), word.end(), [](char c) { return is_latin(c) || is_digit(c) || c == '_'; });
}

std::string subscript_part(std::string_view part, bool of_sigma) {
  if (of_sigma && part.size() > 1 && part[0] == 'm' && is_digit(part[1])) return "−" + std::string(part.substr(1));
  const auto letter = greek_letter(part);
  return std::string(letter.empty() ? part : letter);
}

std::string subscript(std::string_view names, bool of_sigma) {
  std::string text;
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find('_', begin), names.size());
    if (begin > 0) text += ',';
    text += subscript_part(names.substr(begin, end - begin), of_sigma);
    begin = end + 1;
  }
  return text;
}

void append_base(Text& text, std::string_view base) {
  const std::size_t digits = std::min(base.find_first_of("0123456789"), base.size());
  const std::string_view stem = base.substr(0, digits);
  if (const auto letter = greek_letter(stem); !letter.empty()) {
    text.push_back({std::string(letter), Face::symbol});
  } else {
    text.push_back({std::string(stem), stem.size() == 1 ? Face::symbol : Face::words});
  }
  if (digits < base.size()) text.push_back({std::string(base.substr(digits)), Face::words});
}

void append_symbol(Text& text, std::string_view name) {
  const std::size_t bar = std::min(name.find('_'), name.size());
  append_base(text, name.substr(0, bar));
  if (bar + 1 < name.size())
    text.push_back({subscript(name.substr(bar + 1), name.starts_with("sigma")), Face::subscript});
}

void append_words(Text& text, std::string_view words) {
  if (words.empty()) return;
  if (!text.empty() && text.back().face == Face::words) {
    text.back().text += words;
  } else {
    text.push_back({std::string(words), Face::words});
  }
}

/// The next piece of a text: a marked name, a blank, or the text between blanks.
std::string_view next_piece(std::string_view rest) {
  if (rest.front() == mark_open) return rest.substr(0, std::min(rest.find(mark_close), rest.size() - 1) + 1);
  if (rest.front() == ' ') return rest.substr(0, 1);
  return rest.substr(0, std::min(rest.find_first_of(" \x0e"), rest.size()));
}

/// Widths of Helvetica rounded up, in hundredths of the size; a letter beyond ASCII counts as a wide lower-case one.
double advance(unsigned char c) {
  constexpr std::string_view narrow = "ijl.,:;|'!", slim = "frtI()[]-/ ", wide = "mwMW%@";
  const char letter = static_cast<char>(c);
  if (c >= 0x80) return (c & 0xC0) == 0x80 ? 0.0 : 0.62;
  if (narrow.find(letter) != std::string_view::npos) return 0.30;
  if (slim.find(letter) != std::string_view::npos) return 0.38;
  if (wide.find(letter) != std::string_view::npos) return 0.92;
  return letter >= 'A' && letter <= 'Z' ? 0.71 : 0.60;
}

}  // namespace

std::string symbol(std::string_view words) {
  return is_name(words) ? mark_open + std::string(words) + mark_close : std::string(words);
}

Text typeset(std::string_view words) {
  Text text;
  if (is_name(words)) {
    append_symbol(text, words);
    return text;
  }
  for (std::string_view rest = words; !rest.empty();) {
    const std::string_view piece = next_piece(rest);
    const bool marked = piece.front() == mark_open;
    const std::string_view name = marked ? piece.substr(1, piece.size() - 2) : piece;
    const bool is_symbol = is_name(name) && (marked || name.find('_') != std::string_view::npos);
    is_symbol ? append_symbol(text, name) : append_words(text, name);
    rest.remove_prefix(piece.size());
  }
  return text;
}

std::string with_minus(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "−");
  return number;
}

std::string plain(std::string_view words) {
  std::string text;
  for (const Run& run : typeset(words)) text += (run.face == Face::subscript ? "_" : "") + run.text;
  return text;
}

double width(const Text& text, double size) {
  double sum = 0.0;
  for (const Run& run : text) {
    double ems = 0.0;
    for (const char c : run.text) ems += advance(static_cast<unsigned char>(c));
    sum += run.face == Face::subscript ? 0.74 * ems : ems;
  }
  return sum * size;
}

}  // namespace loadpath::draw
