// Errors of a project, at their places: the messages of `loadpath run`, and the states of the parts.
#pragma once

#include "cli/lsp/open_file.hpp"

#include <string>
#include <vector>

namespace loadpath::cli::lsp {

/// Numbers defined by the protocol.
enum class Weight : int { error = 1, warning = 2, information = 3 };

struct Diagnostic {
  Range range;
  Weight weight = Weight::error;
  std::string message;
};

/// The diagnostics of a refreshed file, in the order of their places.
std::vector<Diagnostic> diagnostics_of(const OpenFile& file);

}  // namespace loadpath::cli::lsp
