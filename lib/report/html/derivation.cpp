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

/// "= a + b"; the line may break between terms.
std::string side(const std::vector<std::string>& terms) {
  std::string out;
  for (const std::string& term : terms) out.append(out.empty() ? "" : "<wbr>").append(term);
  return out;
}

/// The first cell of a line is one element.
std::string left_of(const Step& step) {
  const std::string left = symbol(step.symbol);
  if (left.starts_with("<i>")) return "<p>" + bare(left) + "</p>";
  return left.starts_with("<math>") ? left : "<span>" + left + "</span>";
}

void append_cell(std::string& out, const std::string& content) {
  if (!content.empty()) ((out += "<p>") += content) += "</p>";
}

/// The two sides of an equation, each empty if it says nothing more than its result.
struct Sides {
  std::string formula, numbers;
};

Sides sides_of(const Step& step, const Worked& w, const std::string& result) {
  if (step.formula.empty()) return {};
  if (!w.tree) return {"<code>= " + escaped(step.formula) + "</code>", ""};
  Sides sides{side(formula::equation_html(*w.tree, {}, w.known)),
              side(formula::equation_html(*w.tree, w.substituted, w.known))};
  if (sides.numbers == sides.formula || sides.numbers == result) sides.numbers.clear();
  if (sides.formula == result) return {};
  return sides;
}

std::string_view setting_class(Setting setting) {
  switch (setting) {
    case Setting::row:
      return "";
    case Setting::two_rows:
      return "long";
    case Setting::wide:
      return "long wide";
    case Setting::small:
      return "long wide small";
  }
  return "";
}

/// None for a line of all cells in a single row: most are. A "v" is a value without a formula, a "k" a formula without
/// numbers to put in, an "n" a line without words.
std::string classes_of(Setting setting, const Sides& sides, bool has_words) {
  std::string names(setting_class(setting));
  const std::string_view missing = sides.formula.empty() ? "v" : sides.numbers.empty() ? "k" : "";
  for (const std::string_view name : {missing, std::string_view(has_words ? "" : "n")}) {
    if (!name.empty()) names.append(names.empty() ? "" : " ").append(name);
  }
  return names.empty() ? names : " class=\"" + names + "\"";
}

}  // namespace

std::optional<Derivation> as_lines(const Table& table) {
  constexpr std::size_t most = 3;
  const bool is_list = table.caption.empty() && table.head.size() == 3 && table.head[0].id == "symbol";
  if (!is_list || table.rows.size() > most) return std::nullopt;
  Derivation lines;
  for (const auto& row : table.rows) {
    const auto* const symbol = std::get_if<Symbol>(&row[0]);
    const auto* const meaning = std::get_if<Message>(&row[1]);
    const auto* const value = std::get_if<Quantity>(&row[2]);
    if (symbol == nullptr || meaning == nullptr || value == nullptr) return std::nullopt;
    lines.steps.push_back({symbol->name, "", {}, *value, *meaning});
  }
  return lines;
}

// A report has some thousand lines, so their cells are known by their places: symbol, formula, numbers, result, words.
std::string derivation(const Derivation& derivation) {
  std::string out = "<ul class=\"derivation\">\n";
  for (const Step& step : derivation.steps) {
    const std::string result = formula::equation_html(written(step.value));
    const Worked w = step.formula.empty() ? Worked{} : worked(step);
    const Sides sides = sides_of(step, w, result);
    (out += "<li").append(classes_of(setting_of(step, w), sides, !step.why.empty())).append(">") += left_of(step);
    append_cell(out, sides.formula);
    append_cell(out, sides.numbers);
    append_cell(out, result);
    append_cell(out, prose(step.why.text()));
    out += "</li>\n";
  }
  return out + "</ul>\n";
}

}  // namespace loadpath::report::page
