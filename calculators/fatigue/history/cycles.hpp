// The cycles of a history: of a series by rainflow, or of blocks as they are given.
#pragma once

#include "calculators/fatigue/history/types.hpp"
#include "lib/rainflow/cycle.hpp"

#include <vector>

namespace loadpath::fatigue {

/// In Pa, without any factor; `where` of the samples or positions of the series, of blocks their place in the list.
struct Collective {
  std::vector<rainflow::Cycle> cycles, small;  // of which the gate leaves out the small ones
  double largest = 0.0, least = 0.0;
};
Collective collective_of(const HistoryTypes::Input& in);

/// What a series counts, in Pa and without the gate, by its method and its rule for the residue.
void count_into(const HistoryTypes::Input& in, rainflow::Consumer& consumer);

/// One turn of what turns: it comes again, and begins anywhere.
bool is_turn(const HistoryTypes::Input& in);

/// Of one passage, where a mechanism says it; else unset.
Time time_of_turn(const HistoryTypes::Input& in);

}  // namespace loadpath::fatigue
