#include "lib/formula/formula.hpp"
#include "lib/report/latex/tex.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/worked.hpp"
#include "lib/text/latex.hpp"

#include <algorithm>

namespace loadpath::report::tex {
namespace {

std::string left_side(std::string_view name) {
  const std::string_view symbol = named_symbol(name).symbol;
  return is_word(symbol) ? "\\text{" + latex_text(symbol) + "}" : formula::symbol_tex(symbol);
}

/// Formulas between equality signs, each on a separate line.
std::string aligned(const std::vector<std::string>& sides, const std::string& value) {
  std::string out = "\\begin{aligned} " + sides[0] + " &= " + sides[1];
  if (sides.size() > 2) out += " \\\\ &= " + sides[2];
  return out + (sides.size() > 2 ? " = " : " \\\\ &= ") + value + " \\end{aligned}";
}

std::string on_one_line(const std::vector<std::string>& sides, const std::string& value) {
  std::string out;
  for (const std::string& side : sides) out += side + " = ";
  return out + value;
}

/// Left, formula, numbers: those that add to the value.
std::vector<std::string> sides_of(const Step& step, const Worked& w, const std::string& value) {
  std::vector<std::string> sides{left_side(step.symbol)};
  if (!w.tree) {
    if (!step.formula.empty()) sides.push_back("\\text{\\ttfamily " + latex_text(step.formula) + "}");
    return sides;
  }
  const std::string symbolic = formula::tex(*w.tree, {}, w.known);
  const std::string numeric = formula::tex(*w.tree, w.substituted, w.known);
  if (symbolic == value) return sides;
  sides.push_back(symbolic);
  if (numeric != symbolic && numeric != value) sides.push_back(numeric);
  return sides;
}

std::string step_text(const Step& step) {
  const Worked w = worked(step);
  const std::string value = formula::quantity_tex(written(step.value));
  const std::vector<std::string> sides = sides_of(step, w, value);
  const std::string line = on_one_line(sides, value);
  return "\\lpstep{" + line + "}\n  {" + (sides.size() > 1 ? aligned(sides, value) : line) + "}\n  {" +
         latex_text(step.why.text()) + "}\n";
}

}  // namespace

std::string derivation(const Derivation& derivation) {
  std::string out;
  for (const Step& step : derivation.steps) out += step_text(step);
  return out + "\n";
}

}  // namespace loadpath::report::tex
