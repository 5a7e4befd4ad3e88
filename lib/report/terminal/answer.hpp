#pragma once

#include "lib/project/project.hpp"

namespace loadpath::terminal {

/// The last part on the screen: modes that do not pass, choices for each part with their governing modes, the
/// verdict. `in_full`: every failure mode in a row.
void show_answer(const project::Project& project, bool in_full);

}  // namespace loadpath::terminal
