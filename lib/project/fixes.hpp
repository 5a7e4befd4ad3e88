// The remedies for failure modes that are not assessed, as data.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// When all steps are solved: of every mode that another step would assess, what that step would take of this one.
void name_fixes(Project& project);

}  // namespace loadpath::project
