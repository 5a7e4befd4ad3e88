// How an evaluation comes out: verdicts on its checks and limits, and what they say of the modes of failure.
#pragma once

#include "lib/project/run/typed_values.hpp"

#include <vector>

namespace loadpath::project {

/// What is held against the part, and where nothing could be computed every check that is asked for.
void add_verdicts(const Evaluation& evaluation, const Results& results, std::vector<account::Verdict>& verdicts);

/// Beside the modes of failure of the calculator what leaves the step unjudged: an input that lacks, loads that are all
/// zero, values without a reason.
void add_modes(const Evaluation& evaluation, const Results& results, const WeighedValues& weighed,
               const std::vector<account::Verdict>& verdicts, account::Modes& modes);

}  // namespace loadpath::project
