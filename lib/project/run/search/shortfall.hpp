// What a candidate of a search fails, and how far it is from passing.
#pragma once

#include "lib/project/run/search/passing.hpp"

namespace loadpath::project {

/// The largest check, and the factor by which limits are exceeded; 1 passes.
struct Shortfall {
  double check = 1.0, limit = 1.0;
};
/// At the sizes that were settled.
Shortfall shortfall_of_candidate(Evaluation& evaluation, Passing& passing);

/// What the candidate is refused for, at the sizes that follow from it.
Message fault_of_candidate(Evaluation& evaluation, Passing& passing);

}  // namespace loadpath::project
