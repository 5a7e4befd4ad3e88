#pragma once

#include "lib/project/project.hpp"

namespace loadpath::terminal {

/// The last that is seen: what does not pass, what was chosen for each part with what governs, the verdict.
/// `in_full`: every failure mode in a row.
void show_answer(const project::Project& project, bool in_full);

}  // namespace loadpath::terminal
