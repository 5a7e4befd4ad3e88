// The result of a search for the best design: the point, and its neighbours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace loadpath::sweep {

/// A neighbour of the best point: one variable changed, in the stock by one value or to another word.
struct Neighbour {
  enum class Outcome {
    breaks,     // violates a constraint, and the best point does not; if that does too: is not nearer to feasibility
    no_better,  // feasible, and its objective is not better
    better      // the search ended before it could go there
  };
  std::size_t variable = 0;
  bool up = false;       // to the next larger place
  bool resized = false;  // the continuous variables were searched again, else they are unchanged
  Outcome outcome = Outcome::no_better;
  std::size_t broken = 0;  // the constraint that is broken most; their number where none is
  std::vector<double> point, outputs;
};

struct Optimum {
  enum class Scope {
    every_point,        // every point of a finite set
    every_combination,  // every combination of the stock, each with the continuous variables at a local optimum
    local               // better than its neighbours and than the results from other starts
  };
  std::vector<double> point, outputs;
  bool allowed = false;   // otherwise it is the point with the smallest violation
  std::size_t worst = 0;  // the constraint that is broken most; their number where none is
  Scope scope = Scope::local;
  bool budget_spent = false;
  std::uint64_t candidates = 0;       // number of points if all were evaluated; else 0
  std::uint64_t evaluations = 0;      // including those of the proof, which meets some points again
  std::vector<Neighbour> neighbours;  // a side without a neighbour is the end of the range
};

}  // namespace loadpath::sweep
