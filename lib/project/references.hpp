// What a step takes whole from others: records become operands, one for each field that they fill; words, lists and
// rows are compared with what they are to fill, and numbers with what they mean (lib/calculator/meaning.hpp).
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Called in order of evaluation, before the step is prepared: the steps that it refers to are known.
void settle_references(Step& step, const Project& project, std::vector<Issue>& issues);

/// Called before a step is solved, when those that it refers to are. A value handed on as what it is not becomes an
/// issue: a fatigue limit in bending, for one in shear.
void check_meanings(const Step& step, const Project& project, std::vector<Issue>& issues);

/// "lever.drive.M" -> "lever", "drive.M".
std::pair<std::string, std::string> split_step(const std::string& path);

}  // namespace loadpath::project
