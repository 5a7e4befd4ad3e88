// The steps of a project with the tables in them, and where a name that is referred to stands.
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

/// Where the step, the value, the row of the project's own stands that is referred to at the offset.
std::optional<Range> definition_at(const OpenFile& file, std::size_t offset);

}  // namespace loadpath::cli::lsp
