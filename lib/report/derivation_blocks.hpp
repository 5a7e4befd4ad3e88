// The lines of a calculation as blocks of a document.
#pragma once

#include "lib/account/account.hpp"
#include "lib/report/document.hpp"

#include <vector>

namespace loadpath::report {

/// Runs of values that are taken from elsewhere are tables. Where the elements of a list go through the same formulas,
/// one of them is worked out and the others follow in a table.
std::vector<Block> derivation_blocks(const std::vector<account::Derived>& lines);

}  // namespace loadpath::report
