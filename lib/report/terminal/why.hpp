// Why a solved step came out as it did, on the terminal.
#pragma once

#include "lib/project/project.hpp"

#include <string>

namespace loadpath::terminal {

/// The verdict of every step, and what decides it.
void show_deciding(const project::Project& project);

/// What was chosen, what decides, the formulas that lead there and what these start from. `of`: a result or a mode of
/// failure; empty: what decides over the step. False, with a message on standard error, where there is no such.
bool show_why(const project::Step& step, const std::string& of);

}  // namespace loadpath::terminal
