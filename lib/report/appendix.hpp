// The appendix of a report: every step with its inputs, formulas, results and checks.
#pragma once

#include "lib/project/project.hpp"
#include "lib/report/detail.hpp"
#include "lib/report/document.hpp"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::report {

/// Figures that pages before the appendix show in full; it does not repeat them.
using ShownFigures = std::set<const figure::Figure*>;

/// Load factors, then step by step: inputs, formulas, results, checks; at the end the references. A formula set is
/// printed once: a step that repeats it refers to the first one and lists its numbers.
std::vector<Block> appendix_blocks(const project::Project& project, Detail detail, const ShownFigures& shown);

/// The elements of lists, a table for each list, under its key.
std::vector<Table> list_tables(const std::vector<const account::Entry*>& entries);
std::vector<const account::Entry*> pointers_to(const std::vector<account::Entry>& entries);

/// A value as one cell: a number, a word, or the range of a series.
Cell cell_of(const account::Entry& entry);
/// Whether a result is a safety factor, and no ratio of two of them.
bool is_safety(const account::Entry& entry);
/// Whether a value is known.
bool is_available(const account::Entry& entry);

/// Folds rows of the same field over the elements of a list: for a check the row with the largest value, for a limit
/// the range of the values; the tables have them all. Rows that do not pass remain.
std::vector<Verdict> folded(const std::vector<Verdict>& rows);

/// The factors that are applied, each once: by step, symbol, meaning and value. A factor that is neither given nor
/// used by a verdict belongs to another method.
struct AppliedFactor {
  const project::Step* step;
  const account::Entry* entry;
};
std::vector<AppliedFactor> applied_factors(const project::Project& project);

/// An input with a value that the user justifies: "T", its value as "200 N·m" (empty if there is none), the reason.
struct Justified {
  std::string input, value, reason;
  /// "T = 200 N·m"
  [[nodiscard]] std::string name() const { return value.empty() ? input : input + " = " + value; }
};
std::vector<Justified> justified_values(const project::Step& step);

/// The keys of sources that a text names in brackets: "[B19] (4)" -> "B19".
std::set<std::string> keys_in(std::string_view text);
/// The citations of keys; without rows if none is known.
Table citations(const std::set<std::string>& keys);

}  // namespace loadpath::report
