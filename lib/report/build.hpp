// The report of a solved project, as a document.
#pragma once

#include "lib/project/project.hpp"
#include "lib/report/detail.hpp"
#include "lib/report/document.hpp"

#include <set>
#include <string>
#include <string_view>

namespace loadpath::report {

/// `input`: the text of the project, for its fingerprint, and for the appendix of a full report.
Document build(const project::Project& project, std::string_view program, Detail detail = Detail::normal,
               std::string_view input = {});

/// The elements of lists, a table for each list, under its key.
std::vector<Table> list_tables(const std::vector<account::Entry>& entries);

/// The lines of a calculation as blocks: where the elements of a list go through the same formulas, one of them is
/// worked out and the others follow in a table.
std::vector<Block> derivation_blocks(const std::vector<account::Derived>& lines);

/// Folds rows of the same field over the elements of a list: for a check the row with the largest value, for a limit
/// the range of the values; the tables have them all. Rows that do not pass remain.
std::vector<Verdict> folded(const std::vector<Verdict>& rows);

/// The keys of sources that a text names in brackets: "[B19] (4)" -> "B19".
std::set<std::string> keys_in(std::string_view text);

}  // namespace loadpath::report
