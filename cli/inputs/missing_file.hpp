// The help for a file that cannot be read.
#pragma once

#include <string>

namespace loadpath::cli {

/// "did you mean 'shaft.toml'?", "no such file"; for what is there and cannot be read, "a project is a file".
std::string help_for_file(const std::string& file);

}  // namespace loadpath::cli
