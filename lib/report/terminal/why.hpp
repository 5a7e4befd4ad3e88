// Why a solved step came out as it did, on the terminal.
#pragma once

#include "lib/project/project.hpp"

#include <string>

namespace loadpath::terminal {

/// The mode of failure that decides over every step.
void show_deciding(const project::Project& project);

/// What a value or a mode of failure follows from: the formulas that lead there and what these start from. `of` empty:
/// everything of the step that does not pass, what was chosen, and the formulas of the mode that tells most. False,
/// with a message on standard error alone, where there is no such.
bool show_why(const project::Step& step, const std::string& of);

}  // namespace loadpath::terminal
