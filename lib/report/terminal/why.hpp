// Why a solved step came out as it did, on the terminal.
#pragma once

#include "lib/project/project.hpp"

#include <string>

namespace loadpath::terminal {

/// What a value or a mode of failure follows from: the formulas that lead there and what these start from. `of` empty:
/// the verdict on the step, its size, the formulas of the mode that governs, and what is not assessed. False, with a
/// message on standard error only, where there is no such.
bool show_why(const project::Project& project, const project::Step& step, const std::string& of);

}  // namespace loadpath::terminal
