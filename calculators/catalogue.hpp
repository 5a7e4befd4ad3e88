#pragma once

#include "lib/project/catalogue.hpp"

namespace loadpath {

/// Every calculator of the program with the step that runs it, in the order in which `list` shows them.
project::Catalogue catalogue();
/// The calculators only.
Calculators calculators();

}  // namespace loadpath
