// What titles say of a machine, and its numbers.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// A load, a mass, a power, a speed or a temperature in the title of the step, or in that of the project for its last
/// loaded step, that no number of the file is, though it has others of that kind. Nothing where such quantities vary.
std::vector<ReducedLoad> titles_of_other_loads(const Step& step, const Project& project);

/// Choices of supports, loading and axes that the title of the step contradicts: ends = "fixed_fixed" of "rod with pins
/// at both ends".
std::vector<ReducedLoad> titles_of_other_choices(const Step& step, const Project& project);

}  // namespace loadpath::project
