// The best design: by going through all of them where they are few, else by search, with a proof against its
// neighbours.
#pragma once

#include "lib/sweep/search/problem.hpp"

namespace loadpath::sweep {

struct Effort {
  std::uint64_t budget = 1'000'000;      // evaluations, after which the search ends; the proof comes on top
  std::uint64_t enumerated = 1'000'000;  // a finite set of designs up to this size, and the budget, is gone through
  std::size_t starts = 16;               // of the search
  double step = 1e-3;                    // of a continuous variable's range, to its neighbours
};

/// A point beside the best one: one variable changed, in the stock by one value or to another word.
struct Neighbour {
  enum class Outcome {
    breaks,     // a constraint, and the best point does not; where that breaks too: is no nearer to being allowed
    no_better,  // allowed, and its objective is no better
    better      // the search ended before it could go there
  };
  std::size_t variable = 0;
  bool up = false;       // to the next larger place
  bool resized = false;  // the continuous variables were searched anew, else they stay
  Outcome outcome = Outcome::no_better;
  std::size_t broken = 0;  // the constraint that is broken most; their number where none is
  std::vector<double> point, outputs;
};

struct Optimum {
  enum class Reach {
    every_point,        // of a finite set
    every_combination,  // of the stock, each with the continuous variables at a local optimum
    local               // better than its neighbours and than what was found from the other starts
  };
  std::vector<double> point, outputs;
  bool allowed = false;   // else it is the point that breaks least
  std::size_t worst = 0;  // the constraint that is broken most; their number where none is
  Reach reach = Reach::local;
  bool budget_spent = false;
  std::uint64_t candidates = 0;       // where every point was gone through, how many there are; else 0
  std::uint64_t evaluations = 0;      // those of the proof too, which meets some points again
  std::vector<Neighbour> neighbours;  // a side without a neighbour is the end of the range
};

/// The same problem and effort give the same bits. What the function throws is thrown on.
[[nodiscard]] Optimum minimise(const Problem& problem, const Effort& effort = {});

}  // namespace loadpath::sweep
