#include "lib/formula/formula.hpp"
#include "lib/report/columns.hpp"
#include "lib/report/html/html.hpp"
#include "lib/report/worked.hpp"
#include "lib/text/markup.hpp"

namespace loadpath::report::page {
namespace {

/// "= a + b" as formulas between which the line may break.
std::string side(std::vector<std::string> terms) {
  terms.front().insert(0, "<mo>=</mo>");
  std::string out;
  for (const std::string& term : terms) {
    out += (out.empty() ? "<math displaystyle=\"true\">" : "<wbr><math displaystyle=\"true\">") + term + "</math>";
  }
  return out;
}

std::string result(const Quantity& value) { return side({formula::quantity_mathml(written(value))}); }

/// Formula, numbers, value; the numbers move to a line of their own where one is too short.
std::string sides(const Step& step) {
  const std::string value = result(step.value);
  if (step.formula.empty()) return value;
  const Worked w = worked(step);
  if (!w.tree) return "<code>= " + escaped(step.formula) + "</code> " + value;
  const std::string symbolic = side(formula::mathml_terms(*w.tree, {}, w.known));
  const std::string numeric = side(formula::mathml_terms(*w.tree, w.substituted, w.known));
  const bool says_more = numeric != symbolic && numeric != value;
  if (symbolic == value) return value;
  return symbolic + "<wbr><span class=\"numbers\">" + (says_more ? numeric + "<wbr>" : "") + value + "</span>";
}

/// Whether it takes half a line: an imported value, or a short formula with a short reason.
bool is_half(const Step& step, const Worked& w) {
  constexpr double half = 46.0, formula = 34.0;  // letters
  if (step.formula.empty()) return true;
  if (!w.tree) return false;
  const auto sides =
      static_cast<double>(formula::breadth(*w.tree, {}, w.known) + formula::breadth(*w.tree, w.substituted, w.known));
  const double letters = sides + letters_of(formula::quantity_plain(written(step.value)));
  return letters <= formula && letters + letters_of(step.why.text()) <= half;
}

/// Full width for a formula that cannot be broken to fit next to its reason, or on a page at all.
std::string_view width_class(const Step& step) {
  constexpr std::size_t beside_reason = 58, page = 84;  // letters
  const Worked w = worked(step);
  if (is_half(step, w)) return "step half";
  const std::size_t letters = w.tree ? formula::breadth(*w.tree, w.substituted, w.known) : step.formula.size();
  if (letters > page) return "step wide small";
  return letters > beside_reason ? "step wide" : "step";
}

}  // namespace

std::string derivation(const Derivation& derivation) {
  std::string out = "<div class=\"derivation\">\n";
  for (const Step& step : derivation.steps) {
    out += "<div class=\"" + std::string(width_class(step)) + "\"><div class=\"formula\"><div class=\"left\">" +
           symbol(step.symbol) + "</div><div class=\"right\">" + sides(step) + "</div></div>";
    if (!step.why.empty()) out += "<p class=\"why\">" + escaped(step.why.text()) + "</p>";
    out += "</div>\n";
  }
  return out + "</div>\n";
}

}  // namespace loadpath::report::page
