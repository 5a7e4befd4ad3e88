// The name of the program and its version.
#pragma once

#include <string>

namespace loadpath::cli {

/// "loadpath 0.2.0"
std::string program();

}  // namespace loadpath::cli
