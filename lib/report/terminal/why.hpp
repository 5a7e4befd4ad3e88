// Why a solved step came out as it did, on the terminal.
#pragma once

#include "lib/project/project.hpp"

#include <string>

namespace loadpath::terminal {

/// The failure mode that decides over every step.
void show_deciding(const project::Project& project);

/// The derivation of a value or a failure mode: the formulas that lead there and their inputs. `of` empty: all modes
/// of the step that do not pass, its choices, and the formulas of the governing mode. False, with a message on
/// standard error only, if there is no such path.
bool show_why(const project::Step& step, const std::string& of);

}  // namespace loadpath::terminal
