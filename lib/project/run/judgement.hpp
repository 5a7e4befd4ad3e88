// The outcome of an evaluation: verdicts on its checks and limits, and the resulting failure modes.
#pragma once

#include "lib/project/run/typed_values.hpp"

#include <vector>

namespace loadpath::project {

/// Checks and limits of the part; if nothing could be computed, every active check.
void add_verdicts(const Evaluation& evaluation, const Results& results, std::vector<account::Verdict>& verdicts);

/// In addition to the failure modes of the calculator, reasons that leave the step unassessed: a missing input, loads
/// that are all zero, values without a reason.
void add_modes(const Evaluation& evaluation, const Results& results, const WeighedValues& weighed,
               const std::vector<account::Verdict>& verdicts, account::Modes& modes);

}  // namespace loadpath::project
