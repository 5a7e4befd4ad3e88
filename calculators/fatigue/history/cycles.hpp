// The cycles of a history: of a series by rainflow, or of blocks as they are given.
#pragma once

#include "calculators/fatigue/history/types.hpp"
#include "lib/rainflow/cycle.hpp"

#include <vector>

namespace loadpath::fatigue {

/// The cycles above the omission level, in Pa and without any factor.
std::vector<rainflow::Cycle> cycles_of(const HistoryTypes::Input& in);

/// The maximum and minimum stress, in Pa.
struct Extremes {
  double largest = 0.0, least = 0.0;
};
Extremes extremes_of(const HistoryTypes::Input& in);

/// Counted cycles of a series, in Pa and without omission level, by its method and its rule for the residue. `placed`:
/// with the places of their begin and end.
void count_into(const HistoryTypes::Input& in, rainflow::Consumer& consumer, bool placed);

/// The blocks as cycles; none of a series.
std::vector<rainflow::Cycle> cycles_of_blocks(const HistoryTypes::Input& in);

/// One turn of what turns: it comes again, and begins anywhere.
bool is_turn(const HistoryTypes::Input& in);

/// Duration of one passage, if a mechanism gives it; else unset.
Time time_of_turn(const HistoryTypes::Input& in);

}  // namespace loadpath::fatigue
