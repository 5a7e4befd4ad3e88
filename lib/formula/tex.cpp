#include "lib/formula/formula.hpp"
#include "lib/formula/print.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>

// No backslash before a punctuation mark (\, \{ \|) for which TeX has a word: Markdown would swallow it.

namespace loadpath::formula {
namespace {

std::string braced(std::string_view text) { return "{" + std::string(text) + "}"; }
std::string upright(std::string_view text) { return "\\mathrm" + braced(text); }
std::string between(std::string_view open, std::string_view inner, std::string_view close) {
  return "\\left" + std::string(open) + " " + std::string(inner) + " \\right" + std::string(close);
}

std::string ascii_minus(std::string_view number) {
  constexpr std::string_view minus = "−";
  return number.starts_with(minus) ? "-" + std::string(number.substr(minus.size())) : std::string(number);
}

/// An invalid name: characters that TeX or a page would read as markup are removed.
std::string without_markup(std::string text) {
  std::erase_if(text, [](char c) { return std::string_view("\\{}$&#^_%~<>\"`*|").find(c) != std::string_view::npos; });
  return text;
}

std::string glyphs(const Glyphs& g) {
  if (g.greek != nullptr) return std::string(g.greek->tex);
  if (g.text.starts_with("−")) return ascii_minus(g.text);
  const std::string letters = without_markup(g.text);
  const bool plain = g.italic || letters.find_first_not_of("0123456789.") == std::string::npos;
  return plain ? letters : upright(letters);
}

std::string word_text(const Word& word) {
  std::string text;
  for (const Glyphs& g : word) text += glyphs(g) + (g.greek != nullptr && word.size() > 1 ? " " : "");
  return text;
}
std::string subscripts(const std::vector<Word>& words) {
  std::string row;
  for (const Word& word : words) row += (row.empty() ? "" : ",") + word_text(word);
  return row;
}

struct Sign {
  std::string_view text;
  std::string_view tex;
};
constexpr std::array unit_signs = {Sign{"·", "{\\cdot}"}, Sign{"°", "^{\\circ}"}, Sign{"%", "\\%"}, Sign{"µ", "\\mu "},
                                   Sign{"μ", "\\mu "}};

std::string unit_letters(std::string_view letters) {
  std::string tex;
  while (!letters.empty()) {
    const auto sign =
        std::find_if(unit_signs.begin(), unit_signs.end(), [&](const Sign& s) { return letters.starts_with(s.text); });
    const bool found = sign != unit_signs.end();
    tex += found ? sign->tex : letters.substr(0, 1);
    letters.remove_prefix(found ? sign->text.size() : 1);
  }
  return tex;
}
std::string unit_text(std::string_view pretty) {
  std::string tex;
  for (const UnitRun& run : unit_runs(pretty)) {
    tex += unit_letters(run.letters);
    if (!run.exponent.empty()) tex += "^" + braced(ascii_minus(run.exponent));
  }
  return upright(tex);
}

struct Name {
  std::string_view cpp;
  std::string_view tex;
};
constexpr std::array names = {Name{"log", "\\ln"},      Name{"asin", "\\arcsin"}, Name{"acos", "\\arccos"},
                              Name{"atan", "\\arctan"}, Name{"*", " \\cdot "},    Name{"<", " \\lt "},
                              Name{">", " \\gt "},      Name{"<=", " \\le "},     Name{">=", " \\ge "},
                              Name{"==", " = "},        Name{"!=", " \\ne "},     Name{"&&", " \\land "},
                              Name{"||", " \\lor "}};

std::string named(std::string_view cpp, std::string otherwise) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const Name& n) { return n.cpp == cpp; });
  return found == names.end() ? std::move(otherwise) : std::string(found->tex);
}

class Tex : public Notation {
 public:
  std::string words(std::string_view text) const override { return "\\text" + braced(text); }
  std::string number(std::string_view digits) const override { return std::string(digits); }
  std::string symbol(const Symbol& s, std::string_view exponent) const override {
    std::string tex = glyphs(s.base);
    if (!s.subscripts.empty()) tex += "_" + braced(subscripts(s.subscripts));
    if (s.star || !exponent.empty()) {
      tex += "^" + braced((s.star ? exponent.empty() ? "\\ast" : "\\ast " : "") + std::string(exponent));
    }
    return tex;
  }
  std::string unit(std::string_view pretty) const override { return unit_text(pretty); }
  std::string quantity(std::string_view number, std::string_view unit) const override {
    return std::string(number) + (takes_space(unit) ? thin_space() : "") + unit_text(unit);
  }
  std::string minus() const override { return "-"; }
  std::string infix(std::string_view op) const override { return named(op, " " + std::string(op) + " "); }
  std::string thin_space() const override { return "\\thinspace "; }
  std::string fraction(std::string_view over, std::string_view under) const override {
    return "\\frac" + braced(over) + braced(under);
  }
  std::string power(std::string_view base, std::string_view exponent, Level) const override {
    return std::string(base) + "^" + braced(exponent);
  }
  std::string root(int degree, std::string_view radicand) const override {
    return "\\sqrt" + (degree == 2 ? "" : "[" + std::to_string(degree) + "]") + braced(radicand);
  }
  std::string fenced(std::string_view inner) const override { return between("(", inner, ")"); }
  std::string magnitude(std::string_view inner) const override { return between("\\vert", inner, "\\vert"); }
  std::string call(std::string_view function, const std::vector<std::string>& arguments) const override {
    std::string list;
    for (const std::string& a : arguments) list += (list.empty() ? "" : ", ") + a;
    return named(function, "\\" + std::string(function)) + fenced(list);
  }
  std::string either(std::string_view condition, std::string_view yes, std::string_view no) const override {
    return "\\begin{cases}" + std::string(yes) + " & " + words("if ") + std::string(condition) + " \\cr " +
           std::string(no) + " & " + words("otherwise") + "\\end{cases}";
  }
};

const Tex notation;

}  // namespace

std::string symbol_tex(std::string_view name) { return notation.symbol(symbol(name), {}); }
std::string tex(const Node& tree, const Substituted& substituted, const Known& known) {
  return print(notation, tree, substituted, known);
}
std::string quantity_tex(const Written& value) { return print_quantity(notation, value); }

}  // namespace loadpath::formula
