// Completions at a place, in the form of the protocol.
#pragma once

#include "cli/lsp/open_file.hpp"

#include <string>
#include <vector>

namespace loadpath::cli::lsp {

/// Numbers defined by the protocol.
enum class Kind : int { function = 3, field = 5, module = 9, unit = 11, value = 12, enumeration = 20, structure = 22 };

struct Completion {
  std::string label;
  Kind kind = Kind::value;
  std::string detail = {};
  std::string meaning = {};
  std::string text = {};     // inserted text; empty: the label
  std::string snippet = {};  // the same with places to fill in: "d = \"$1 mm\""; empty: the text
  int rank = 1;              // lower ones come first
};

struct Completions {
  Range range;  // range that they replace
  std::vector<Completion> items;
};

}  // namespace loadpath::cli::lsp
