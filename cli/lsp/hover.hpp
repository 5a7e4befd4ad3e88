// The text shown for the element under the pointer.
#pragma once

#include "cli/lsp/open_file.hpp"

#include <optional>
#include <string>

namespace loadpath::cli::lsp {

struct Hover {
  Range range;
  std::string text;  // Markdown
};

/// A step, a field, a quantity in other units, a row, an expression with its references.
std::optional<Hover> hover_at(const OpenFile& file, std::size_t offset);

}  // namespace loadpath::cli::lsp
