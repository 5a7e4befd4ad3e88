#include "lib/report/columns.hpp"

#include "lib/formula/formula.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/worked.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::report {
namespace {

constexpr int few_digits = 4;  // digits of numbers in many columns; the calculation and JSON have more

std::string shared_unit(const Table& table, std::size_t column) {
  std::string typed, unit;
  for (const auto& row : table.rows) {
    const auto* const q = column < row.size() ? std::get_if<Quantity>(&row[column]) : nullptr;
    if (q == nullptr || !std::isfinite(q->si) || (!unit.empty() && q->unit == typed)) continue;
    typed = q->unit;
    const std::string own = pretty_unit(typed);
    if (own.empty() || (!unit.empty() && own != unit)) return {};
    unit = own;
  }
  return unit;
}

double letters_in(const Cell& of, const std::string& number) {
  if (std::holds_alternative<Quantity>(of)) return letters_of(number);
  constexpr double longest_word = 13.0;  // "not available" breaks
  if (const auto* const text = std::get_if<std::string>(&of)) return letters_of(*text);
  if (const auto* const sized = std::get_if<Sized>(&of)) return letters_of(sized->text + sized->behind()) + 1.0;
  return longest_word;
}

}  // namespace

double letters_of(std::string_view text) {
  return static_cast<double>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string number_of(Quantity q, const Column& column) {
  if (std::isinf(q.si)) return q.si > 0.0 ? "∞" : "−∞";
  q.digits = std::min(q.digits, few_digits);
  formula::Written number = written(q);
  if (!column.unit.empty()) number.unit.clear();
  return formula::quantity_plain(number);
}

Column column_of(const Table& table, std::size_t index, bool numeric) {
  Column column{index, numeric, shared_unit(table, index)};
  constexpr double symbol_share = 0.6;  // its subscript is small
  column.letters = symbol_share * letters_of(formula::symbol_plain(table.head[index].text()));
  column.numbers.reserve(table.rows.size());
  for (const auto& row : table.rows) {
    const auto* const q = index < row.size() ? std::get_if<Quantity>(&row[index]) : nullptr;
    column.numbers.push_back(q == nullptr ? std::string() : number_of(*q, column));
    if (index < row.size()) column.letters = std::max(column.letters, letters_in(row[index], column.numbers.back()));
  }
  return column;
}

std::vector<Part> parts_of(const std::vector<Column>& columns, double letters_of_line) {
  const Column& first = columns.front();
  std::vector<Part> parts{{{first}, first.letters}};
  for (std::size_t i = 1; i < columns.size(); ++i) {
    const double more = between_columns + columns[i].letters;
    if (parts.back().letters + more > letters_of_line && parts.back().columns.size() > 1)
      parts.push_back({{first}, first.letters});
    parts.back().columns.push_back(columns[i]);
    parts.back().letters += more;
  }
  return parts;
}

}  // namespace loadpath::report
