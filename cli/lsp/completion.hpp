// Completions at the cursor, also in a file that does not parse.
#pragma once

#include "cli/lsp/completions.hpp"
#include "cli/lsp/open_file.hpp"

#include <string>
#include <vector>

namespace loadpath::cli::lsp {

Completions completions_at(const OpenFile& file, std::size_t offset);

}  // namespace loadpath::cli::lsp
