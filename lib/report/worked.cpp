#include "lib/report/worked.hpp"

#include "lib/formula/names.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::report {
namespace {

constexpr int given_digits = 5;

const Step::Given* find(const Step& step, std::string_view name) {
  const auto found =
      std::find_if(step.given.begin(), step.given.end(), [&](const Step::Given& given) { return given.name == name; });
  return found == step.given.end() ? nullptr : &*found;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name(std::string_view text) {
  return !text.empty() && is_letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
}

}  // namespace

formula::Written written(const Quantity& quantity) {
  const std::string number = format_number(in_unit(quantity.si, quantity.unit), quantity.digits);
  return {number, std::isfinite(quantity.si) ? pretty_unit(quantity.unit) : ""};
}

Worked worked(const Step& step) {
  const auto substituted = [&step](std::string_view name) -> std::optional<formula::Written> {
    const Step::Given* given = find(step, name);
    if (given == nullptr || std::isnan(given->si)) return std::nullopt;
    return written({given->si, given->unit, given_digits});
  };
  const auto known = [&step](std::string_view name) -> std::optional<double> {
    const Step::Given* given = find(step, name);
    return given == nullptr ? std::nullopt : std::optional(given->si);
  };
  return {formula::parse(step.formula), substituted, known};
}

namespace {

/// Letters of a side of an equation; of a sum those of all terms.
std::size_t letters_of_side(const formula::Extent& side) {
  return side.terms > 1 ? side.widest + (side.terms - 1) * (side.widest + 1) / 2 : side.widest;
}

}  // namespace

Setting setting_of(const Step& step, const Worked& w) {
  constexpr std::size_t formula_column = 23, numbers_column = 23, both_columns = 54, three_columns = 68;  // letters
  if (step.formula.empty()) return Setting::row;
  if (!w.tree) return step.formula.size() > formula_column ? Setting::two_rows : Setting::row;
  const formula::Extent symbols = formula::extent(*w.tree, {}, w.known);
  const formula::Extent values = formula::extent(*w.tree, w.substituted, w.known);
  const std::size_t formula = letters_of_side(symbols), numbers = letters_of_side(values);
  if (formula <= formula_column && numbers <= numbers_column) return Setting::row;
  const std::size_t longest = std::max(formula, numbers);
  if (longest <= both_columns) return Setting::two_rows;
  return std::max(symbols.widest, values.widest) <= three_columns ? Setting::wide : Setting::small;
}

Setting setting_of(const Step& step) { return step.formula.empty() ? Setting::row : setting_of(step, worked(step)); }

NamedSymbol named_symbol(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string_view::npos) return {{}, path};
  return {path.substr(0, dot), path.substr(dot + 1)};
}

bool is_symbol(const Message& head) {
  if (head.id != "{1}" || head.args.empty()) return false;
  const std::string name = head.args[0].text();
  if (!is_name(name)) return false;
  return name.size() == 1 || name.find('_') != std::string::npos || formula::symbol_plain(name) != name;
}

std::vector<const Heading*> listed_headings(const Document& document) {
  constexpr std::size_t least = 4;
  std::vector<const Heading*> headings;
  for (const Block& block : document.blocks) {
    const auto* heading = std::get_if<Heading>(&block);
    if (heading != nullptr && heading->level <= 2) headings.push_back(heading);
  }
  if (headings.size() < least) headings.clear();
  return headings;
}

std::vector<bool> numeric_columns(const Table& table) {
  std::vector<bool> quantity, other;
  for (const auto& row : table.rows) {
    quantity.resize(std::max(quantity.size(), row.size()));
    other.resize(quantity.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto* text = std::get_if<std::string>(&row[i]);
      const bool is_quantity = std::holds_alternative<Quantity>(row[i]) || std::holds_alternative<Utilisation>(row[i]);
      const bool is_capped = text != nullptr && text->starts_with("> ");  // "> 1000"
      const bool empty = text != nullptr && (text->empty() || is_capped);
      quantity[i] = quantity[i] || is_quantity;
      other[i] = other[i] || (!is_quantity && !empty);
    }
  }
  for (std::size_t i = 0; i < quantity.size(); ++i) quantity[i] = quantity[i] && !other[i];
  quantity.resize(std::max(quantity.size(), table.head.size()));
  return quantity;
}

}  // namespace loadpath::report
