// Common functions of the writers for steps and values: names, numbers and trees ready to be printed.
#pragma once

#include "lib/formula/formula.hpp"
#include "lib/report/document.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::report {

formula::Written written(const Quantity& quantity);

/// A step's formula and how its names are printed; it refers to the step.
struct Worked {
  std::optional<formula::Node> tree;  // none: no formula, or a text outside the language
  formula::Substituted substituted;
  formula::Known known;
};
Worked worked(const Step& step);

/// How a line of a calculation is set on the grid of the report: symbol, formula, numbers, result, reason.
enum class Setting {
  row,       // in one row
  two_rows,  // the formula and its numbers below each other, over both of their columns
  wide,      // over the column of the result too, which follows below
  small      // likewise, in smaller type
};
Setting setting_of(const Step& step);
/// The same of a formula that is parsed already.
Setting setting_of(const Step& step, const Worked& w);

/// "segments[2].u_tau": the place, empty at the top, and the symbol.
struct NamedSymbol {
  std::string_view where;
  std::string_view symbol;
};
NamedSymbol named_symbol(std::string_view path);

/// A heading of a table that consists of a symbol: "tau_t", "d".
bool is_symbol(const Message& head);

/// The headings of steps and chapters, which contents list; none if a document is too short for contents.
std::vector<const Heading*> listed_headings(const Document& document);

/// Columns that hold quantities, where they hold anything, are set flush right.
std::vector<bool> numeric_columns(const Table& table);

}  // namespace loadpath::report
