#include "lib/formula/names.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace loadpath::formula {
namespace {

// Capitals that look like Latin ones have no macro in TeX.
constexpr std::array greek = {Greek{"alpha", "α", "\\alpha"},
                              Greek{"beta", "β", "\\beta"},
                              Greek{"gamma", "γ", "\\gamma"},
                              Greek{"delta", "δ", "\\delta"},
                              Greek{"epsilon", "ε", "\\varepsilon"},
                              Greek{"eps", "ε", "\\varepsilon"},
                              Greek{"zeta", "ζ", "\\zeta"},
                              Greek{"eta", "η", "\\eta"},
                              Greek{"theta", "θ", "\\theta"},
                              Greek{"iota", "ι", "\\iota"},
                              Greek{"kappa", "κ", "\\kappa"},
                              Greek{"lambda", "λ", "\\lambda"},
                              Greek{"mu", "μ", "\\mu"},
                              Greek{"nu", "ν", "\\nu"},
                              Greek{"xi", "ξ", "\\xi"},
                              Greek{"omicron", "ο", "o"},
                              Greek{"pi", "π", "\\pi"},
                              Greek{"rho", "ρ", "\\rho"},
                              Greek{"sigma", "σ", "\\sigma"},
                              Greek{"tau", "τ", "\\tau"},
                              Greek{"upsilon", "υ", "\\upsilon"},
                              Greek{"phi", "φ", "\\varphi"},
                              Greek{"chi", "χ", "\\chi"},
                              Greek{"psi", "ψ", "\\psi"},
                              Greek{"omega", "ω", "\\omega"},
                              Greek{"Alpha", "Α", "\\mathrm{A}"},
                              Greek{"Beta", "Β", "\\mathrm{B}"},
                              Greek{"Gamma", "Γ", "\\Gamma"},
                              Greek{"Delta", "Δ", "\\Delta"},
                              Greek{"Epsilon", "Ε", "\\mathrm{E}"},
                              Greek{"Zeta", "Ζ", "\\mathrm{Z}"},
                              Greek{"Eta", "Η", "\\mathrm{H}"},
                              Greek{"Theta", "Θ", "\\Theta"},
                              Greek{"Iota", "Ι", "\\mathrm{I}"},
                              Greek{"Kappa", "Κ", "\\mathrm{K}"},
                              Greek{"Lambda", "Λ", "\\Lambda"},
                              Greek{"Mu", "Μ", "\\mathrm{M}"},
                              Greek{"Nu", "Ν", "\\mathrm{N}"},
                              Greek{"Xi", "Ξ", "\\Xi"},
                              Greek{"Omicron", "Ο", "\\mathrm{O}"},
                              Greek{"Pi", "Π", "\\Pi"},
                              Greek{"Rho", "Ρ", "\\mathrm{P}"},
                              Greek{"Sigma", "Σ", "\\Sigma"},
                              Greek{"Tau", "Τ", "\\mathrm{T}"},
                              Greek{"Upsilon", "Υ", "\\Upsilon"},
                              Greek{"Phi", "Φ", "\\Phi"},
                              Greek{"Chi", "Χ", "\\mathrm{X}"},
                              Greek{"Psi", "Ψ", "\\Psi"},
                              Greek{"Omega", "Ω", "\\Omega"}};

Glyphs letters(std::string_view text) {
  const auto found = text.size() < 2 ? greek.end()  // no name of a letter is one letter
                                     : std::find_if(greek.begin(), greek.end(), [&](const Greek& g) {
                                         return g.name.front() == text.front() && g.name == text;
                                       });
  if (found != greek.end()) return {std::string(text), &*found, text != "pi"};
  return {std::string(text), nullptr, text.size() == 1};
}

/// The start of the digits at the end of a word.
std::size_t stem(std::string_view word) {
  const std::size_t last = word.find_last_not_of("0123456789");
  return last == std::string_view::npos ? 0 : last + 1;
}

Word subscript(std::string_view text, const Glyphs& base) {
  const std::string_view name = text.substr(0, stem(text)), digits = text.substr(name.size());
  const bool fatigue_limit = base.text == "sigma" || base.text == "tau";
  Word word;
  if (fatigue_limit && name == "m" && !digits.empty()) {
    return {{"−" + std::string(digits), nullptr, false}};
  }
  const bool is_mixed = name.size() > 1 && letters(name).greek == nullptr && letters(name.substr(1)).greek != nullptr;
  if (is_mixed) {  // K_Hbeta
    word.push_back(letters(name.substr(0, 1)));
    word.push_back(letters(name.substr(1)));
  } else if (!name.empty()) {
    word.push_back(letters(name));
  }
  if (name == "p" && digits == "02") {
    word.push_back({"0.2", nullptr, false});  // proof strength
  } else if (!digits.empty()) {
    word.push_back({std::string(digits), nullptr, false});
  }
  return word;
}

}  // namespace

Symbol symbol(std::string_view name) {
  const std::size_t bar = std::min(name.find('_', 1), name.size());
  const std::string_view base = name.substr(0, bar);
  const std::size_t end = stem(base) == 0 ? base.size() : stem(base);
  Symbol s{letters(base.substr(0, end)), {}, false};
  if (end < base.size()) s.subscripts.push_back(subscript(base.substr(end), s.base));
  for (std::size_t from = bar; from < name.size();) {
    const std::size_t next = std::min(name.find('_', from + 1), name.size());
    const std::string_view part = name.substr(from + 1, next - from - 1);
    if (part == "star") s.star = true;
    if (!part.empty() && part != "star") s.subscripts.push_back(subscript(part, s.base));
    from = next;
  }
  return s;
}

int template_number(std::string_view function) {
  int number = 1;
  const std::size_t open = function.find('<') + 1;
  std::from_chars(function.data() + open, function.data() + function.size(), number);
  return number;
}

}  // namespace loadpath::formula
