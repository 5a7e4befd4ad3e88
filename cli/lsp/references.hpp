// The possible references of an expression at the cursor: steps and their results, values, functions.
#pragma once

#include "cli/lsp/completions.hpp"
#include "lib/calculator/record.hpp"

namespace loadpath::cli::lsp {

/// `field`: that the expression is for, whose dimension comes first; null if it is none.
Completions references_at(const OpenFile& file, const Spot& spot, std::size_t offset, const FieldInfo* field);

}  // namespace loadpath::cli::lsp
