#pragma once

#include "lib/calculator.hpp"

namespace loadpath {

/// Every calculator of the program, in the order in which `list` shows them.
Catalogue catalogue();

}  // namespace loadpath
