#include "lib/report/latex/letters.hpp"

#include "lib/text/utf8.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace loadpath::report::tex {
namespace {

struct Range {
  char32_t first, last;
};
/// The letters in the T1 and TS1 encodings of LaTeX.
constexpr std::array known = {
    Range{0x00A0, 0x00B1}, Range{0x00B4, 0x00B6}, Range{0x00B8, 0x00B8}, Range{0x00BA, 0x0125}, Range{0x0128, 0x0137},
    Range{0x0139, 0x013E}, Range{0x0141, 0x0148}, Range{0x014A, 0x0165}, Range{0x0168, 0x017E}, Range{0x0218, 0x021B},
    Range{0x1E9E, 0x1E9E}, Range{0x2010, 0x2015}, Range{0x2018, 0x201A}, Range{0x201C, 0x201E}, Range{0x2020, 0x2022},
    Range{0x2026, 0x2026}, Range{0x2030, 0x2030}, Range{0x2039, 0x203A}, Range{0x20AC, 0x20AC}, Range{0x2116, 0x2116},
    Range{0x2122, 0x2122}};
constexpr Range cyrillic{0x0400, 0x045F};  // T2A does not have two of these, which no living language uses
constexpr std::array<char32_t, 2> not_in_t2a = {0x040D, 0x045D};

struct Sign {
  char32_t letter;
  std::string_view tex;
};
constexpr std::array signs = {
    Sign{U'·', "\\cdot"},
    Sign{U'²', "^{2}"},
    Sign{U'³', "^{3}"},
    Sign{U'¹', "^{1}"},
    Sign{U'⁰', "^{0}"},
    Sign{U'⁴', "^{4}"},
    Sign{U'⁵', "^{5}"},
    Sign{U'⁶', "^{6}"},
    Sign{U'⁷', "^{7}"},
    Sign{U'⁸', "^{8}"},
    Sign{U'⁹', "^{9}"},
    Sign{U'⁺', "^{+}"},
    Sign{U'⁻', "^{-}"},
    Sign{U'₀', "_{0}"},
    Sign{U'₁', "_{1}"},
    Sign{U'₂', "_{2}"},
    Sign{U'₃', "_{3}"},
    Sign{U'₄', "_{4}"},
    Sign{U'₅', "_{5}"},
    Sign{U'₆', "_{6}"},
    Sign{U'₇', "_{7}"},
    Sign{U'₈', "_{8}"},
    Sign{U'₉', "_{9}"},
    Sign{0x2009, "\\,"},
    Sign{0x200B, ""},
    Sign{0x202F, "\\,"},
    Sign{U'Γ', "\\Gamma"},
    Sign{U'Δ', "\\Delta"},
    Sign{U'Θ', "\\Theta"},
    Sign{U'Λ', "\\Lambda"},
    Sign{U'Ξ', "\\Xi"},
    Sign{U'Π', "\\Pi"},
    Sign{U'Σ', "\\Sigma"},
    Sign{U'Υ', "\\Upsilon"},
    Sign{U'Φ', "\\Phi"},
    Sign{U'Ψ', "\\Psi"},
    Sign{U'Ω', "\\Omega"},
    Sign{U'Α', "\\mathrm{A}"},
    Sign{U'Β', "\\mathrm{B}"},
    Sign{U'Ε', "\\mathrm{E}"},
    Sign{U'Ζ', "\\mathrm{Z}"},
    Sign{U'Η', "\\mathrm{H}"},
    Sign{U'Ι', "\\mathrm{I}"},
    Sign{U'Κ', "\\mathrm{K}"},
    Sign{U'Μ', "\\mathrm{M}"},
    Sign{U'Ν', "\\mathrm{N}"},
    Sign{U'Ο', "\\mathrm{O}"},
    Sign{U'Ρ', "\\mathrm{P}"},
    Sign{U'Τ', "\\mathrm{T}"},
    Sign{U'Χ', "\\mathrm{X}"},
    Sign{U'α', "\\alpha"},
    Sign{U'β', "\\beta"},
    Sign{U'γ', "\\gamma"},
    Sign{U'δ', "\\delta"},
    Sign{U'ε', "\\varepsilon"},
    Sign{U'ζ', "\\zeta"},
    Sign{U'η', "\\eta"},
    Sign{U'θ', "\\theta"},
    Sign{U'ι', "\\iota"},
    Sign{U'κ', "\\kappa"},
    Sign{U'λ', "\\lambda"},
    Sign{U'μ', "\\mu"},
    Sign{U'ν', "\\nu"},
    Sign{U'ξ', "\\xi"},
    Sign{U'ο', "o"},
    Sign{U'π', "\\pi"},
    Sign{U'ρ', "\\rho"},
    Sign{U'ς', "\\varsigma"},
    Sign{U'σ', "\\sigma"},
    Sign{U'τ', "\\tau"},
    Sign{U'υ', "\\upsilon"},
    Sign{U'φ', "\\varphi"},
    Sign{U'χ', "\\chi"},
    Sign{U'ψ', "\\psi"},
    Sign{U'ω', "\\omega"},
    Sign{U'ϑ', "\\vartheta"},
    Sign{U'ϕ', "\\phi"},
    Sign{U'ℓ', "\\ell"},
    Sign{U'′', "^{\\prime}"},
    Sign{U'″', "^{\\prime\\prime}"},
    Sign{U'←', "\\leftarrow"},
    Sign{U'↑', "\\uparrow"},
    Sign{U'→', "\\rightarrow"},
    Sign{U'↓', "\\downarrow"},
    Sign{U'↔', "\\leftrightarrow"},
    Sign{U'⇒', "\\Rightarrow"},
    Sign{U'∂', "\\partial"},
    Sign{U'∈', "\\in"},
    Sign{U'∑', "\\sum"},
    Sign{U'−', "-"},
    Sign{U'∓', "\\mp"},
    Sign{U'∙', "\\cdot"},
    Sign{U'⋅', "\\cdot"},
    Sign{U'√', "\\surd"},
    Sign{U'∛', "\\sqrt[3]{}"},
    Sign{U'∜', "\\sqrt[4]{}"},
    Sign{U'∞', "\\infty"},
    Sign{U'∠', "\\angle"},
    Sign{U'∥', "\\parallel"},
    Sign{U'∧', "\\land"},
    Sign{U'∨', "\\lor"},
    Sign{U'∫', "\\int"},
    Sign{U'≈', "\\approx"},
    Sign{U'≠', "\\ne"},
    Sign{U'≡', "\\equiv"},
    Sign{U'≤', "\\le"},
    Sign{U'≥', "\\ge"},
    Sign{U'≪', "\\ll"},
    Sign{U'≫', "\\gg"},
    Sign{U'⊥', "\\perp"},
    Sign{U'⌀', "\\varnothing"},
    Sign{U'█', "\\rule{0.5em}{1.5ex}"},
    Sign{U'■', "\\blacksquare"},
    Sign{U'□', "\\square"},
    Sign{U'◇', "\\Diamond"},
    Sign{U'○', "\\circ"},
    Sign{U'●', "\\bullet"},
    Sign{U'✓', "\\checkmark"},
    Sign{U'✗', "\\boldsymbol{\\times}"},
};

bool is_in(Range range, char32_t letter) { return letter >= range.first && letter <= range.last; }
bool is_known(char32_t letter) {
  return std::any_of(known.begin(), known.end(), [&](const Range& range) { return is_in(range, letter); });
}
bool is_cyrillic(char32_t letter) {
  return is_in(cyrillic, letter) && std::find(not_in_t2a.begin(), not_in_t2a.end(), letter) == not_in_t2a.end();
}

std::string number_of(char32_t letter) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string out;
  for (int shift = 20; shift >= 0; shift -= 4) {
    const std::size_t digit = (letter >> shift) & 0xFU;
    if (digit != 0 || !out.empty() || shift < 16) out += digits[digit];
  }
  return out;
}

std::string declared(char32_t letter) {
  const auto* const sign = std::find_if(signs.begin(), signs.end(), [&](const Sign& s) { return s.letter == letter; });
  const std::string number = number_of(letter);
  const std::string as =
      sign != signs.end() ? "\\ensuremath{" + std::string(sign->tex) + "}" : "\\lpmissing{" + number + "}";
  return "\\DeclareUnicodeCharacter{" + number + "}{" + as + "}\n";
}

std::set<char32_t> letters_beyond_ascii(std::string_view body) {
  std::set<char32_t> letters;
  for (const char32_t letter : code_points(body)) {
    if (letter >= 0xA0) letters.insert(letter);
  }
  return letters;
}

}  // namespace

std::string declared_letters(std::string_view body) {
  std::string out, of_cyrillic;
  for (const char32_t letter : letters_beyond_ascii(body)) {
    if (!is_known(letter)) (is_cyrillic(letter) ? of_cyrillic : out) += declared(letter);
  }
  if (of_cyrillic.empty()) return out;
  return out + "\\IfFileExists{t2aenc.def}{\\usepackage[T2A,T1]{fontenc}}{% apt-get install texlive-lang-cyrillic\n" +
         of_cyrillic + "}\n";
}

}  // namespace loadpath::report::tex
