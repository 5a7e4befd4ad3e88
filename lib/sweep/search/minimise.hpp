// The best design: by going through all of them where they are few, else by search, with a proof against its
// neighbours.
#pragma once

#include "lib/sweep/search/optimum.hpp"
#include "lib/sweep/search/problem.hpp"

namespace loadpath::sweep {

struct Effort {
  std::uint64_t budget = 1'000'000;      // evaluations, after which the search ends; the proof comes on top
  std::uint64_t enumerated = 1'000'000;  // a finite set of designs up to this size, and the budget, is gone through
  std::size_t starts = 16;               // number of starts of the search
  double step = 1e-3;                    // relative to a continuous variable's range, to its neighbours
};

/// The same problem and effort give the same bits. Exceptions of the function are passed on.
[[nodiscard]] Optimum minimise(const Problem& problem, const Effort& effort = {});

}  // namespace loadpath::sweep
