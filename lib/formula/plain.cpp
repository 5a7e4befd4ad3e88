#include "lib/formula/formula.hpp"
#include "lib/formula/print.hpp"
#include "lib/quantity/format.hpp"

#include <array>

namespace loadpath::formula {
namespace {

constexpr std::array<std::string_view, 10> raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

bool is_whole(std::string_view exponent) {
  const bool minus = exponent.starts_with("−");
  if (minus) exponent.remove_prefix(std::string_view("−").size());
  return !exponent.empty() && exponent.find_first_not_of("0123456789") == std::string_view::npos;
}
std::string superscript(std::string_view exponent) {
  std::string text = exponent.starts_with("−") ? "⁻" : "";
  for (const char c : exponent) {
    if (c >= '0' && c <= '9') text += raised[static_cast<std::size_t>(c - '0')];
  }
  return text;
}

class Plain : public Notation {
 public:
  bool stacked() const override { return false; }
  std::string words(std::string_view text) const override { return std::string(text); }
  std::string number(std::string_view digits) const override { return std::string(digits); }
  std::string symbol(const Symbol& s, std::string_view exponent) const override {
    std::string text = s.base.letters() + (s.star ? "*" : "");
    for (std::size_t i = 0; i < s.subscripts.size(); ++i) {
      text += i == 0 ? "_" : ",";
      for (const Glyphs& g : s.subscripts[i]) text += g.letters();
    }
    return text + std::string(exponent);
  }
  std::string unit(std::string_view pretty) const override { return std::string(pretty); }
  std::string quantity(std::string_view number, std::string_view unit) const override {
    return with_unit(std::string(number), unit);
  }
  std::string minus() const override { return "−"; }
  std::string infix(std::string_view op) const override { return " " + std::string(sign(op)) + " "; }
  std::string thin_space() const override { return " "; }
  std::string fraction(std::string_view over, std::string_view under) const override {
    return std::string(over) + " / " + std::string(under);
  }
  std::string power(std::string_view base, std::string_view exponent, Level of_exponent) const override {
    if (is_whole(exponent)) return std::string(base) + superscript(exponent);
    return std::string(base) + "^" + (of_exponent == Level::atom ? std::string(exponent) : fenced(exponent));
  }
  std::string root(int degree, std::string_view radicand) const override {
    constexpr std::array<std::string_view, 5> signs = {"", "", "√", "∛", "∜"};
    const auto known = static_cast<std::size_t>(degree);
    return (known < signs.size() ? std::string(signs[known]) : superscript(std::to_string(degree)) + "√") +
           fenced(radicand);
  }
  std::string fenced(std::string_view inner) const override { return "(" + std::string(inner) + ")"; }
  std::string magnitude(std::string_view inner) const override { return "|" + std::string(inner) + "|"; }
  std::string call(std::string_view function, const std::vector<std::string>& arguments) const override {
    std::string list;
    for (const std::string& a : arguments) list += (list.empty() ? "" : ", ") + a;
    return (function == "log" ? "ln" : std::string(function)) + fenced(list);
  }
  std::string either(std::string_view condition, std::string_view yes, std::string_view no) const override {
    return std::string(condition) + " ? " + std::string(yes) + " : " + std::string(no);
  }

 private:
  static std::string_view sign(std::string_view op) {
    if (op == "-") return "−";
    if (op == "*") return "·";
    if (op == "<=") return "≤";
    if (op == ">=") return "≥";
    if (op == "==") return "=";
    if (op == "!=") return "≠";
    if (op == "&&") return "and";
    return op == "||" ? "or" : op;
  }
};

const Plain plain_notation;

}  // namespace

std::string symbol_plain(std::string_view name) { return plain_notation.symbol(symbol(name), {}); }
std::string plain(const Node& tree, const Substituted& substituted, const Known& known) {
  return print(plain_notation, tree, substituted, known);
}
std::string quantity_plain(const Written& value) { return print_quantity(plain_notation, value); }

}  // namespace loadpath::formula
