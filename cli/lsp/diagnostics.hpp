// What is wrong with a project, at its places: what `loadpath run` would say, and how the parts came out.
#pragma once

#include "cli/lsp/open_file.hpp"

#include <string>
#include <vector>

namespace loadpath::cli::lsp {

/// By the numbers of the protocol.
enum class Weight : int { error = 1, warning = 2, information = 3 };

struct Diagnostic {
  Range range;
  Weight weight = Weight::error;
  std::string message;
};

/// Of a file that was refreshed, in the order of their places.
std::vector<Diagnostic> diagnostics_of(const OpenFile& file);

}  // namespace loadpath::cli::lsp
