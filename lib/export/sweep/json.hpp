// The results of a sweep, as JSON: numbers in SI.
#pragma once

#include "lib/project/sweep/statistics.hpp"

#include <string>
#include <string_view>

namespace loadpath::exports {

std::string json_of(const project::Project& project, const project::SweepPlan& plan,
                    const project::SweepStatistics& found, std::string_view program);

}  // namespace loadpath::exports
