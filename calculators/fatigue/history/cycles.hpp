// The cycles of a history: of a series by rainflow, or of blocks as they are given.
#pragma once

#include "calculators/fatigue/history/types.hpp"
#include "lib/rainflow/cycle.hpp"

#include <vector>

namespace loadpath::fatigue {

/// In Pa, without any factor; `where` of the samples or positions of the series, of blocks their place in the list.
struct Collective {
  std::vector<rainflow::Cycle> cycles, small;  // small: below the omission level
  double largest = 0.0, least = 0.0;
};
Collective collective_of(const HistoryTypes::Input& in);

/// Counted cycles of a series, in Pa and without omission level, by its method and its rule for the residue.
void count_into(const HistoryTypes::Input& in, rainflow::Consumer& consumer);

/// One turn of what turns: it comes again, and begins anywhere.
bool is_turn(const HistoryTypes::Input& in);

/// Duration of one passage, if a mechanism gives it; else unset.
Time time_of_turn(const HistoryTypes::Input& in);

}  // namespace loadpath::fatigue
