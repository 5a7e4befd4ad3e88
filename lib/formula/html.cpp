// Formulas in HTML: text of the math font, a third of the bytes of MathML. Fractions, roots, tables and letters with
// two scripts are elements of MathML in this text; what surrounds them is put into elements in the end.
#include "lib/formula/formula.hpp"
#include "lib/formula/print.hpp"
#include "lib/quantity/format.hpp"
#include "lib/text/markup.hpp"

#include <algorithm>
#include <cstddef>

namespace loadpath::formula {
namespace {

using View = std::string_view;

std::string in_element(View name, View content) {
  const View last = name.substr(0, name.find(' '));
  std::string out;
  out.reserve(name.size() + content.size() + last.size() + 5);
  (out += '<').append(name) += '>';
  ((out.append(content) += '<') += '/').append(last) += '>';
  return out;
}

constexpr View thin_blank = "\u2009", kept_blank = "\u00A0";

/// Text has no elements but scripts, "<sub>" and "<sup>".
constexpr View begin_of_element = "<m";
bool is_text(View markup) { return markup.find(begin_of_element) == View::npos; }
bool has_script(View text) { return text.find('<') != View::npos; }

/// Slanted Latin and Greek letters lie in two rows of 4 bytes that begin with F0 9D.
constexpr char32_t slanted_latin = 0x1D434, slanted_greek = 0x1D6E2;
void append_slanted(std::string& out, char32_t point) {
  out += "\xF0\x9D";
  out += static_cast<char>(0x80U | (point >> 6U & 0x3FU));
  out += static_cast<char>(0x80U | (point & 0x3FU));
}

/// The slanted letter that browsers set for an identifier of one letter; other characters as they are.
void append_identifier(std::string& out, View letter) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(letter[i]); };
  const char c = letter.front();
  if (letter == "h") {
    out += "\u210E";
  } else if (letter.size() == 1 && 'A' <= c && c <= 'Z') {
    append_slanted(out, slanted_latin + byte(0) - 'A');
  } else if (letter.size() == 1 && 'a' <= c && c <= 'z') {
    append_slanted(out, slanted_latin + 26 + byte(0) - 'a');
  } else if (letter.size() == 2 && (byte(0) == 0xCE || byte(0) == 0xCF)) {
    const char32_t point = (byte(0) & 0x1FU) << 6U | (byte(1) & 0x3FU);
    append_slanted(out, point < U'α' ? slanted_greek + point - U'Α' : slanted_greek + 26 + point - U'α');
  } else {
    out += escaped(letter);
  }
}

/// The letter of a text that is one slanted letter; empty of others.
std::string identifier_of(View text) {
  if (text == "\u210E") return "h";
  if (text.size() != 4 || !text.starts_with("\xF0\x9D")) return {};
  const auto bits = [&](std::size_t i) { return static_cast<char32_t>(static_cast<unsigned char>(text[i]) & 0x3FU); };
  const char32_t point = 0x1D000 | bits(2) << 6U | bits(3);
  if (point < slanted_greek) {
    const auto place = static_cast<int>(point - slanted_latin);
    return {static_cast<char>(place < 26 ? 'A' + place : 'a' + place - 26)};
  }
  const char32_t place = point - slanted_greek, letter = place < 26 ? U'Α' + place : U'α' + place - 26;
  return {static_cast<char>(0xC0U | letter >> 6U), static_cast<char>(0x80U | (letter & 0x3FU))};
}

/// The sign of " + ", alone between two elements; empty of other text.
View operation_of(View text) {
  if (text == ",\u2009") return ",";
  if (text.size() < 3 || text.front() != ' ' || text.back() != ' ') return {};
  const View sign = text.substr(1, text.size() - 2);
  const auto byte = static_cast<unsigned char>(sign.front());
  const std::size_t letters = byte < 0x80 ? 1 : byte < 0xE0 ? 2 : 3;
  return sign.size() == letters || sign == "&lt;" || sign == "&gt;" ? sign : View();
}

/// A letter, a letter with one script: shorter as elements of their own. Empty of other text.
std::string letter_element(View text) {
  const std::string alone = identifier_of(text);
  if (!alone.empty()) return in_element("mi", alone);
  const std::size_t open = text.find("<su");
  if (open == View::npos || !(text.ends_with("</sub>") || text.ends_with("</sup>")) || open + 11 > text.size())
    return {};
  const std::string base = identifier_of(text.substr(0, open));
  const std::string script = identifier_of(text.substr(open + 5, text.size() - open - 11));
  if (base.empty() || script.empty()) return {};
  return in_element(text.ends_with("</sub>") ? "msub" : "msup", in_element("mi", base) + in_element("mi", script));
}

/// Text between elements. It is set as numbers are: next to mtext an operator is set as a sign. Blanks at its ends are
/// kept; scripts directly in a token would be blocks.
std::string text_element(View text, bool is_first) {
  const View operation = is_first ? View() : operation_of(text);
  if (!operation.empty()) return in_element("mo", operation);
  std::string letter = letter_element(text);
  if (!letter.empty()) return letter;
  std::string kept(text);
  if (kept.ends_with(' ')) kept.replace(kept.size() - 1, 1, kept_blank);
  if (kept.starts_with(' ')) kept.replace(0, 1, kept_blank);
  return in_element("mn", has_script(kept) ? in_element("i", kept) : kept);
}

std::size_t end_of_element(View markup) {
  int depth = 0;
  for (std::size_t at = 0; at != View::npos; at = markup.find('<', at + 1)) {
    const View tag = markup.substr(at);
    depth += tag.starts_with(begin_of_element) ? 1 : tag.starts_with("</m") ? -1 : 0;
    if (depth == 0) return markup.find('>', at) + 1;
  }
  return markup.size();
}

struct Elements {
  std::string markup;
  int count = 0;
};

/// The elements of the markup, with the text between them as elements.
Elements elements_of(View markup) {
  Elements all;
  while (!markup.empty()) {
    const std::size_t text = std::min(markup.find(begin_of_element), markup.size());
    if (text > 0) all.markup += text_element(markup.substr(0, text), all.count == 0), ++all.count;
    markup.remove_prefix(text);
    if (markup.empty()) break;
    const std::size_t size = end_of_element(markup);
    all.markup += markup.substr(0, size), ++all.count;
    markup.remove_prefix(size);
  }
  return all;
}

/// One child of a fraction or a script: a single element, or a row of them.
std::string one(View markup) {
  Elements all = elements_of(markup);
  return all.count == 1 ? std::move(all.markup) : in_element("mrow", all.markup);
}

/// Operators of a script have no blanks.
std::string close(View script) {
  std::string out;
  for (std::size_t at = 0; at < script.size(); ++at) {
    if (script[at] == ' ') continue;
    out += script[at];
    if (script[at] == ',' && script.substr(at + 1).starts_with(thin_blank)) at += thin_blank.size();
  }
  return out;
}

/// A base with an index ("sub") or an exponent ("sup"); as elements if the script has scripts or is not text.
std::string with_script(View base, View kind, View script) {
  if (is_text(base) && !has_script(script)) return std::string(base) + in_element(kind, close(script));
  return in_element("m" + std::string(kind), one(base) + one(script));
}

/// Delimiters grow only with content taller than a line: the font's next size is far from its content.
bool is_tall(View markup) {
  for (const View tall : {"<mfrac", "<mroot", "<msqrt", "<mtable"}) {
    if (markup.find(tall) != View::npos) return true;
  }
  return false;
}

std::string delimited(View open, View inner, View close) {
  if (is_tall(inner)) {
    const Elements all = elements_of(inner);
    return in_element("mrow", in_element("mo", open) + all.markup + in_element("mo", close));
  }
  const std::string whole = std::string(open).append(inner).append(close);
  return is_text(inner) ? whole : in_element("mrow", elements_of(whole).markup);
}

std::string unit_text(View pretty) {
  std::string out;
  for (const UnitRun& run : unit_runs(pretty)) {
    out += escaped(run.letters);
    if (!run.exponent.empty()) out += in_element("sup", run.exponent);
  }
  return out;
}

void append_glyphs(std::string& out, const Glyphs& g) {
  const View letters = g.greek != nullptr ? g.greek->letter : View(g.text);
  if (g.italic)
    append_identifier(out, letters);
  else
    out += escaped(letters);
}

std::string indices(const std::vector<Word>& words) {
  std::string text;
  for (const Word& word : words) {
    if (!text.empty()) text.append(",").append(thin_blank);
    for (const Glyphs& g : word) append_glyphs(text, g);
  }
  return text;
}

View function_name(View cpp) {
  if (cpp == "log") return "ln";
  if (cpp == "asin") return "arcsin";
  if (cpp == "acos") return "arccos";
  if (cpp == "atan") return "arctan";
  return cpp;
}

class Html : public Notation {
 public:
  std::string words(View text) const override { return escaped(text); }
  std::string number(View digits) const override { return std::string(digits); }
  std::string symbol(const Symbol& s, View exponent) const override {
    std::string base;
    append_glyphs(base, s.base);
    const std::string upper = (s.star ? "*" : "") + std::string(exponent);
    if (s.subscripts.empty()) return upper.empty() ? base : with_script(base, "sup", upper);
    const std::string lower = indices(s.subscripts);
    if (upper.empty()) return with_script(base, "sub", lower);
    return in_element("msubsup", one(base) + one(lower) + one(upper));
  }
  std::string unit(View pretty) const override { return unit_text(pretty); }
  std::string quantity(View number, View unit) const override {
    return with_unit(std::string(number), unit_text(unit), thin_blank);
  }
  std::string minus() const override { return "−"; }
  std::string infix(View op) const override { return " " + std::string(sign(op)) + " "; }
  std::string thin_space() const override { return std::string(thin_blank); }
  std::string fraction(View over, View under) const override { return in_element("mfrac", one(over) + one(under)); }
  std::string power(View base, View exponent, Level) const override { return with_script(base, "sup", exponent); }
  std::string root(int degree, View radicand) const override {
    if (degree == 2) return in_element("msqrt", elements_of(radicand).markup);
    return in_element("mroot", one(radicand) + one(std::to_string(degree)));
  }
  std::string fenced(View inner) const override { return delimited("(", inner, ")"); }
  std::string magnitude(View inner) const override { return delimited("|", inner, "|"); }
  std::string call(View function, const std::vector<std::string>& arguments) const override {
    std::string list;
    for (const std::string& a : arguments) list += (list.empty() ? "" : ",\u2009") + a;
    return std::string(function_name(function)) + fenced(list);
  }
  std::string either(View condition, View yes, View no) const override {
    const auto row = [](View value, View when) {
      return in_element("mtr",
                        in_element("mtd", elements_of(value).markup) + in_element("mtd", elements_of(when).markup));
    };
    const std::string rows = row(yes, words("if").append(thin_blank).append(condition)) + row(no, words("otherwise"));
    return in_element(
        "mrow", "<mo stretchy=true form=prefix>{</mo>" + in_element("mtable class=cases displaystyle=true", rows));
  }

 private:
  static View sign(View op) {
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

const Html html_notation;

/// What is not text alone in its element; the sign of an equation stays text.
std::string in_page(std::string markup) {
  constexpr View equals = "= ";
  if (is_text(markup)) return markup;
  const bool is_equation = markup.starts_with(equals);
  return (is_equation ? "= <math>" : "<math>") +
         elements_of(View(markup).substr(is_equation ? equals.size() : 0)).markup + "</math>";
}

}  // namespace

std::string symbol_html(View name) { return in_page(html_notation.symbol(symbol(name), {})); }
std::string html(const Node& tree, const Substituted& substituted, const Known& known) {
  return in_page(print(html_notation, tree, substituted, known));
}
std::vector<std::string> equation_html(const Node& tree, const Substituted& substituted, const Known& known) {
  std::vector<std::string> terms = print_terms(html_notation, tree, substituted, known);
  terms.front().insert(0, "= ");
  for (std::string& term : terms) term = in_page(std::move(term));
  return terms;
}
std::string equation_html(const Written& value) { return in_page("= " + print_quantity(html_notation, value)); }

}  // namespace loadpath::formula
