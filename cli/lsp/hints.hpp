// The values of expressions, and of searched inputs, shown after them in the line.
#pragma once

#include "cli/lsp/open_file.hpp"

#include <string>
#include <vector>

namespace loadpath::cli::lsp {

struct Hint {
  Position position;
  std::string text;  // "= 12.5 mm"
  std::string more;
};

/// The hints within a range, in the order of the file.
std::vector<Hint> hints_in(const OpenFile& file, const Range& range);

}  // namespace loadpath::cli::lsp
