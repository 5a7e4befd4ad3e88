// Runs of neighbouring positions of a cycle, and their texts.
#pragma once

#include "lib/quantity/format.hpp"
#include "lib/quantity/series.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::planar {

/// From the first of these positions to the last; in a cycle a run may go over its end.
struct Run {
  std::size_t first = 0, last = 0, count = 0;
};

/// The runs of positions where this is so.
inline std::vector<Run> runs_of(const std::vector<bool>& positions, bool so, bool cyclic) {
  std::vector<Run> runs;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (positions[k] != so) continue;
    if (!runs.empty() && runs.back().last + 1 == k) {
      runs.back().last = k;
      ++runs.back().count;
    } else {
      runs.push_back({k, k, 1});
    }
  }
  const bool over_end =
      cyclic && runs.size() > 1 && runs.front().first == 0 && runs.back().last + 1 == positions.size();
  if (over_end) {
    runs.front() = {runs.back().first, runs.front().last, runs.back().count + runs.front().count};
    runs.pop_back();
  }
  return runs;
}

/// A limit that is known better than the positions show it: "124.47°", to the hundredth of its unit.
inline std::string limit_text(double at, const std::string& unit) {
  const double hundredths = std::round(100.0 * in_unit(at, unit));
  return with_unit(format_number(hundredths == 0.0 ? 0.0 : 0.01 * hundredths, 9), pretty_unit(unit));
}

inline std::string place_of(std::size_t k, const Axis& axis) { return format_quantity(axis.at[k], axis.unit, 5); }

/// "between 30° and 60°", the longest run where more than one is, with their number.
inline Message range_of(const std::vector<bool>& positions, bool so, const Axis& axis) {
  const auto runs = runs_of(positions, so, axis.cyclic());
  const auto longest =
      std::max_element(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.count < b.count; });
  const std::string first = place_of(longest->first, axis), last = place_of(longest->last, axis);
  const Message run = longest->count == 1 ? say("at {1}", first) : say("between {1} and {2}", first, last);
  return runs.size() == 1 ? run : say("{1}, the longest of {2} ranges", run, std::to_string(runs.size()));
}

}  // namespace loadpath::planar
