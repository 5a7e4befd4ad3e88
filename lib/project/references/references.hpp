// Complete objects taken from other steps: records become operands, one for each field that they fill; words, lists
// and rows are compared with the fields to fill.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Called in order of evaluation, before the step is prepared: the steps that it refers to are known.
void settle_references(Step& step, const Project& project, std::vector<Issue>& issues);

/// Whether a meaning is a reduction of a series, by its name among the functions of expressions: a field that is just
/// the "amplitude" of a cycle, its "mean", its "max" or "min".
bool is_reduction(const Meaning& meaning);

/// The prefix "others[2]." in "others[2].sigma_max".
std::string prefix_of(const std::string& path);

/// Whether the stress ratio of a cycle is typed as r = -1, `prefix`: prefix of its inputs.
bool has_reversed_ratio(const Step& step, const std::string& prefix, const Project& project);

}  // namespace loadpath::project
