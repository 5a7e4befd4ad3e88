// The neighbours of the best point, each with the reason why it is not selected.
#pragma once

#include "lib/sweep/search/mixed.hpp"
#include "lib/sweep/search/optimum.hpp"

namespace loadpath::sweep {

struct Proof {
  std::vector<Neighbour> neighbours;
  std::vector<Trial> better;  // points better than the given one
};

/// One place up and down of each variable, `step` of their range for continuous ones. Neighbours in the stock are
/// listed twice if there are continuous variables: as they are, and resized by `search`.
[[nodiscard]] Proof proof_of(Trials& trials, MixedSearch& search, const Trial& best, double step);

}  // namespace loadpath::sweep
