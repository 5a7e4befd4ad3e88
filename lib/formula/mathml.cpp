#include "lib/formula/formula.hpp"
#include "lib/formula/print.hpp"
#include "lib/text/markup.hpp"
#include "lib/text/utf8.hpp"

#include <algorithm>
#include <optional>

namespace loadpath::formula {
namespace {

std::string element(std::string_view name, std::string_view content) {
  const std::string_view last = name.substr(0, name.find(' '));
  std::string out;
  out.reserve(name.size() + content.size() + last.size() + 5);
  (out += '<').append(name) += '>';
  ((out.append(content) += '<') += '/').append(last) += '>';
  return out;
}
/// Whether the element that begins the markup also ends it.
bool is_single(std::string_view markup) {
  int depth = 0;
  for (std::size_t at = markup.find('<'); at != std::string_view::npos; at = markup.find('<', at + 1)) {
    const std::size_t end = markup.find('>', at);
    if (end == std::string_view::npos) return false;
    if (markup[at + 1] == '/')
      --depth;
    else if (markup[end - 1] != '/')
      ++depth;
    if (depth == 0) return end + 1 == markup.size();
  }
  return false;
}
/// One child of a fraction or a script: a single element, or a row of them.
std::string one(std::string_view markup) { return is_single(markup) ? std::string(markup) : element("mrow", markup); }
/// Browsers set an identifier of one letter in italics, a longer one upright.
std::string upright(std::string_view letters) {
  return element(code_points(letters).size() == 1 ? "mi mathvariant=\"normal\"" : "mi", letters);
}
constexpr const char* thin_space_letter = "\u2009";
std::string blank(std::string_view width) { return "<mspace width=\"" + std::string(width) + "\"/>"; }

/// Delimiters grow only with content taller than a line: the font's next size is far from its content.
bool is_tall(std::string_view markup) {
  for (const std::string_view tall : {"<mfrac", "<mroot", "<msqrt", "<mtable"}) {
    if (markup.find(tall) != std::string_view::npos) return true;
  }
  return false;
}
/// The text of a single element of this name; nothing of other markup.
std::optional<std::string_view> text_in(std::string_view name, std::string_view markup) {
  const std::string begin = "<" + std::string(name) + ">", end = "</" + std::string(name) + ">";
  if (!markup.starts_with(begin) || !markup.ends_with(end)) return std::nullopt;
  markup.remove_prefix(begin.size());
  markup.remove_suffix(end.size());
  return markup.find('<') == std::string_view::npos ? std::optional(markup) : std::nullopt;
}

/// Around a quantity the delimiters are a part of it. Those that do not grow are set as numbers are: shorter than
/// operators with stretchy = false, and without the space around operators.
std::string delimited(std::string_view open, std::string_view inner, std::string_view close) {
  if (const auto text = text_in("mn", inner)) return element("mn", std::string(open).append(*text).append(close));
  const char* const delimiter = is_tall(inner) ? "mo" : "mn";
  return element("mrow", element(delimiter, open) + std::string(inner) + element(delimiter, close));
}

/// mm⁴ with a raised 4.
std::string unit_markup(std::string_view pretty) {
  std::string out, letters;
  for (const UnitRun& run : unit_runs(pretty)) {
    letters = upright(escaped(run.letters));
    out += run.exponent.empty() ? letters : element("msup", letters + element("mn", run.exponent));
  }
  return out;
}

bool has_exponent(std::string_view pretty) {
  const std::vector<UnitRun> runs = unit_runs(pretty);
  return std::any_of(runs.begin(), runs.end(), [](const UnitRun& run) { return !run.exponent.empty(); });
}

std::string glyphs(const Glyphs& g) {
  if (g.italic) return element("mi", escaped(g.letters()));
  const bool digits = g.text.find_first_of("0123456789") != std::string::npos;
  return digits ? element("mn", escaped(g.text)) : upright(escaped(g.letters()));
}

std::string subscripts(const std::vector<Word>& words) {
  std::string row;
  for (const Word& word : words) {
    if (!row.empty()) row += "<mo>,</mo>";
    for (const Glyphs& g : word) row += glyphs(g);
  }
  return one(row);
}

std::string_view function_name(std::string_view cpp) {
  if (cpp == "log") return "ln";
  if (cpp == "asin") return "arcsin";
  if (cpp == "acos") return "arccos";
  if (cpp == "atan") return "arctan";
  return cpp;
}

class MathML : public Notation {
 public:
  std::string words(std::string_view text) const override { return element("mtext", escaped(text)); }
  std::string number(std::string_view digits) const override { return element("mn", digits); }
  std::string symbol(const Symbol& s, std::string_view exponent) const override {
    const std::string base = glyphs(s.base);
    if (s.star) {
      const std::string upper = one("<mo>*</mo>" + std::string(exponent));
      return s.subscripts.empty() ? element("msup", base + upper)
                                  : element("msubsup", base + subscripts(s.subscripts) + upper);
    }
    if (s.subscripts.empty()) return exponent.empty() ? base : element("msup", base + one(exponent));
    const std::string lower = base + subscripts(s.subscripts);
    return exponent.empty() ? element("msub", lower) : element("msubsup", lower + one(exponent));
  }
  std::string unit(std::string_view pretty) const override { return unit_markup(pretty); }
  /// One number with its unit, unless a power of ten or of a unit is raised. Not as mtext: next to what counts as space
  /// an operator is set as a sign.
  std::string quantity(std::string_view number, std::string_view unit) const override {
    const auto digits = text_in("mn", number);
    if (digits && !has_exponent(unit)) return element("mn", std::string(*digits) + thin_space_letter + escaped(unit));
    return std::string(number) + blank("0.2em") + unit_markup(unit);
  }
  std::string minus() const override { return "<mo form=\"prefix\">−</mo>"; }
  std::string infix(std::string_view op) const override { return element("mo", sign(op)); }
  std::string thin_space() const override { return blank("0.17em"); }
  std::string fraction(std::string_view over, std::string_view under) const override {
    return element("mfrac", one(over) + one(under));
  }
  std::string power(std::string_view base, std::string_view exponent, Level) const override {
    return element("msup", one(base) + one(exponent));
  }
  std::string root(int degree, std::string_view radicand) const override {
    if (degree == 2) return element("msqrt", radicand);
    return element("mroot", one(radicand) + number(std::to_string(degree)));
  }
  std::string fenced(std::string_view inner) const override { return delimited("(", inner, ")"); }
  std::string magnitude(std::string_view inner) const override { return delimited("|", inner, "|"); }
  std::string call(std::string_view function, const std::vector<std::string>& arguments) const override {
    std::string list;
    for (const std::string& a : arguments) list += (list.empty() ? "" : "<mo>,</mo>") + a;
    return element("mi", function_name(function)) + "<mo>\u2061</mo>" + fenced(list);
  }
  std::string either(std::string_view condition, std::string_view yes, std::string_view no) const override {
    const auto row = [](std::string_view value, std::string_view when) {
      return element("mtr", element("mtd", value) + element("mtd", when));
    };
    const std::string rows =
        row(yes, words("if") + blank("0.3em") + std::string(condition)) + row(no, words("otherwise"));
    return element("mrow", "<mo stretchy=\"true\" form=\"prefix\">{</mo>" +
                               element("mtable class=\"cases\" displaystyle=\"true\"", rows));
  }

 private:
  static std::string_view sign(std::string_view op) {
    if (op == "-") return "−";
    if (op == "*") return "⋅";
    if (op == "<") return "&lt;";
    if (op == ">") return "&gt;";
    if (op == "<=") return "≤";
    if (op == ">=") return "≥";
    if (op == "==") return "=";
    if (op == "!=") return "≠";
    if (op == "&&") return "∧";
    if (op == "||") return "∨";
    return op;
  }
};

const MathML mathml_notation;

}  // namespace

std::string symbol_mathml(std::string_view name) { return mathml_notation.symbol(symbol(name), {}); }
std::string mathml(const Node& tree, const Substituted& substituted, const Known& known) {
  return print(mathml_notation, tree, substituted, known);
}
std::vector<std::string> mathml_terms(const Node& tree, const Substituted& substituted, const Known& known) {
  std::vector<std::string> terms = print_terms(mathml_notation, tree, substituted, known);
  // A plus or a minus that begins a term has no left neighbour: without the attribute it would be set as a sign.
  for (std::size_t i = 1; i < terms.size(); ++i) {
    if (terms[i].starts_with("<mo>")) terms[i].insert(3, " form=\"infix\"");
  }
  return terms;
}
std::string quantity_mathml(const Written& value) { return print_quantity(mathml_notation, value); }

}  // namespace loadpath::formula
