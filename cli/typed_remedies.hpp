// Remedies of what was typed on the command line, as the shell takes them.
#pragma once

#include "lib/text/issue.hpp"

#include <string>
#include <vector>

namespace loadpath::cli {

/// The issues; those of a flag name flags: `--l "... mm"` instead of `l = "... mm"`, `--because R_e="..."` instead of
/// `because.R_e = "..."`.
std::vector<Issue> with_flags(std::vector<Issue> issues);

/// A remedy in words of a file, with its inputs as flags: `--crank '{ speed = "60 rpm" }'`.
std::string as_flags(const std::string& text);

}  // namespace loadpath::cli
