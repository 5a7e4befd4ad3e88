// Modes of a part of several elements, each of which another step assesses: the stages of a drive.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// After all steps are solved: a mode of a list gets the state of the steps that assess its elements, if each element
/// has one: a step of the calculators of the mode that refers to the element and to its load.
void settle_elements(Project& project);

/// Whether any step may assess an element of another one.
bool leaves_elements(const Project& project);

}  // namespace loadpath::project
