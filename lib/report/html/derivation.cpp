#include "lib/formula/formula.hpp"
#include "lib/report/html/html.hpp"
#include "lib/report/worked.hpp"
#include "lib/text/markup.hpp"

namespace loadpath::report::page {
namespace {

/// Text of the math font without its element: the cells of a line have this font.
std::string bare(std::string formula) {
  constexpr std::string_view begin = "<i>", end = "</i>";
  if (!formula.starts_with(begin)) return formula;
  return formula.substr(begin.size(), formula.size() - begin.size() - end.size());
}

/// "= a + b" as formulas between which the line may break.
std::string side(std::vector<std::string> terms) {
  terms.front().insert(0, "<mo>=</mo>");
  std::string out;
  for (const std::string& term : terms) {
    out += (out.empty() ? "" : "<wbr>") + bare(math(term));
  }
  return out;
}

/// The first cell of a line is one element.
std::string left_of(const Step& step) {
  const std::string left = symbol(step.symbol);
  return left.starts_with("<i>") || left.starts_with("<math>") ? left : "<span>" + left + "</span>";
}

std::string cell_of(const char* name, const std::string& content) {
  return content.empty() ? "" : "<p class=\"" + std::string(name) + "\">" + content + "</p>";
}

/// The two sides of an equation, each empty if it says nothing more than its result.
struct Sides {
  std::string formula, numbers;
};

Sides sides_of(const Step& step, const Worked& w, const std::string& result) {
  if (step.formula.empty()) return {};
  if (!w.tree) return {"<code>= " + escaped(step.formula) + "</code>", ""};
  Sides sides{side(formula::mathml_terms(*w.tree, {}, w.known)),
              side(formula::mathml_terms(*w.tree, w.substituted, w.known))};
  if (sides.numbers == sides.formula || sides.numbers == result) sides.numbers.clear();
  if (sides.formula == result) return {};
  return sides;
}

/// None for a line in a single row: most are.
std::string_view class_of(const Step& step, const Worked& w) {
  switch (setting_of(step, w)) {
    case Setting::row:
      return "";
    case Setting::two_rows:
      return " class=\"long\"";
    case Setting::wide:
      return " class=\"long wide\"";
    case Setting::small:
      return " class=\"long wide small\"";
  }
  return "";
}

}  // namespace

// The names of the cells are single letters, for a report has some thousand: formula, numbers, why. The result, which
// every line has, is without.
std::string derivation(const Derivation& derivation) {
  std::string out = "<ul class=\"derivation\">\n";
  for (const Step& step : derivation.steps) {
    const std::string result = side({formula::quantity_mathml(written(step.value))});
    const Worked w = step.formula.empty() ? Worked{} : worked(step);
    const Sides sides = sides_of(step, w, result);
    out += "<li" + std::string(class_of(step, w)) + ">" + left_of(step) + cell_of("f", sides.formula) +
           cell_of("n", sides.numbers) + "<p>" + result + "</p>";
    if (!step.why.empty()) out += cell_of("w", prose(step.why.text()));
    out += "</li>\n";
  }
  return out + "</ul>\n";
}

}  // namespace loadpath::report::page
