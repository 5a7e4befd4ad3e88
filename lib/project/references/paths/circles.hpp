// Messages about circular references: how one step takes a value of another, and the line of the file that says so.
#pragma once

#include "lib/project/step.hpp"

#include <string>

namespace loadpath::project {

/// "key1.R_e_1 takes shaft.R_e (line 73)": how the step takes the path of another step; "key1 takes shaft.R_e" if it
/// does so without an input of its own.
Message how_taken(const Step& step, const std::string& path);

/// "bl.d is of the row that 'bl' searches for: name a row there", for a value of a step of the circle that its search
/// has to find first; empty for other values.
Message row_to_name(const Step& source, const std::string& path);

}  // namespace loadpath::project
