// The steps of a project with the tables in them, and the definition of a referenced name.
#pragma once

#include "cli/lsp/open_file.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::cli::lsp {

struct Symbol {
  std::string name;
  std::string detail;  // the calculator
  Range all, at_name;
  std::vector<Symbol> within;
};

std::vector<Symbol> symbols_of(const OpenFile& file);

/// The definition of the step, the value, or the project's own row that is referred to at the offset.
std::optional<Range> definition_at(const OpenFile& file, std::size_t offset);

}  // namespace loadpath::cli::lsp
