// A history in classes of stress: its rainflow matrix, range pairs and level crossings.
#pragma once

#include "calculators/fatigue/history/types.hpp"
#include "lib/figure/figure.hpp"

namespace loadpath::fatigue {

/// Into the lists of the result, with the service factor; they stay empty without classes.
void classify(const HistoryTypes::Input& in, HistoryTypes::Result& r);

/// The range pairs and the level crossings as curves, over their counts.
std::vector<figure::Figure> class_figures(const HistoryTypes::Result& r);

}  // namespace loadpath::fatigue
