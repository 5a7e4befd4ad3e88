// A history in classes of stress: its rainflow matrix, range pairs and level crossings.
#pragma once

#include "calculators/fatigue/history/history.hpp"

namespace loadpath::fatigue {

/// Into the lists of the result, with the service factor; they stay empty without classes.
void classify(const History::Input& in, History::Result& r);

/// The range pairs and the level crossings as curves, over their counts.
std::vector<draw::Figure> class_figures(const History::Result& r);

}  // namespace loadpath::fatigue
