// Figures of a sweep with data for their points: results over each other with the Pareto set, and two inputs with the
// passing region.
#pragma once

#include "lib/report/document.hpp"
#include "lib/report/sweep/points.hpp"

#include <string>
#include <vector>

namespace loadpath::report {

/// None, one or both, each with a sentence.
std::vector<Block> sweep_charts(const project::Project& project, const project::SweepPlan& plan,
                                const project::SweepStatistics& found, const DrawnPoints& drawn);

}  // namespace loadpath::report
