// The results of a sweep, as a document: failure rates of the parts, distributions of the results, notable points,
// and the command that solves one of them separately.
#pragma once

#include "lib/project/sweep/statistics.hpp"
#include "lib/report/document.hpp"
#include "lib/report/sweep/points.hpp"

namespace loadpath::report {

/// `found` holds all points of the plan, or those of a shard; `drawn` those of its figures, none if nothing shows
/// them.
Document sweep_document(const project::Project& project, const project::SweepPlan& plan,
                        const project::SweepStatistics& found, std::string_view program, const DrawnPoints& drawn = {});

}  // namespace loadpath::report
