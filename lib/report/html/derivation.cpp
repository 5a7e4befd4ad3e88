#include "lib/formula/formula.hpp"
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
    out += (out.empty() ? "" : "<wbr>") + math(term);
  }
  return out;
}

std::string cell_of(const char* name, const std::string& content) {
  return content.empty() ? "" : "<p class=\"" + std::string(name) + "\">" + content + "</p>";
}

/// The two sides of an equation, each empty if it says nothing more than its result.
struct Sides {
  std::string formula, numbers;
};

Sides sides_of(const Step& step, const std::string& result) {
  if (step.formula.empty()) return {};
  const Worked w = worked(step);
  if (!w.tree) return {"<code>= " + escaped(step.formula) + "</code>", ""};
  Sides sides{side(formula::mathml_terms(*w.tree, {}, w.known)),
              side(formula::mathml_terms(*w.tree, w.substituted, w.known))};
  if (sides.numbers == sides.formula || sides.numbers == result) sides.numbers.clear();
  if (sides.formula == result) return {};
  return sides;
}

std::string_view class_of(const Step& step) {
  switch (setting_of(step)) {
    case Setting::row:
      return "step";
    case Setting::two_rows:
      return "step long";
    case Setting::wide:
      return "step long wide";
    case Setting::small:
      return "step long wide small";
  }
  return "step";
}

}  // namespace

std::string derivation(const Derivation& derivation) {
  std::string out = "<div class=\"derivation\">\n";
  for (const Step& step : derivation.steps) {
    const std::string result = side({formula::quantity_mathml(written(step.value))});
    const Sides sides = sides_of(step, result);
    out += "<div class=\"" + std::string(class_of(step)) + "\">" + "<div class=\"left\">" + symbol(step.symbol) +
           "</div>" + cell_of("formula", sides.formula) + cell_of("numbers", sides.numbers) + cell_of("result", result);
    if (!step.why.empty()) out += "<p class=\"why\">" + prose(step.why.text()) + "</p>";
    out += "</div>\n";
  }
  return out + "</div>\n";
}

}  // namespace loadpath::report::page
