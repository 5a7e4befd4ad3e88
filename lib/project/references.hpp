// What a step takes whole from others: records become operands, one for each field that they fill; words, lists and
// rows are compared with what they are to fill, and numbers with what they mean: a fatigue limit in bending is none in
// shear (lib/calculator/meaning.hpp), and a shear stress is no normal one.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Called in order of evaluation, before the step is prepared: the steps that it refers to are known.
void settle_references(Step& step, const Project& project, std::vector<Issue>& issues);

/// Called before a step is solved, when those that it refers to are. A value handed on as what it is not becomes an
/// issue, and so does a word that is typed beside a record that has another.
void check_meanings(const Step& step, const Project& project, std::vector<Issue>& issues);

/// "lever.drive.M" -> "lever", "drive.M".
std::pair<std::string, std::string> split_step(const std::string& path);

}  // namespace loadpath::project
