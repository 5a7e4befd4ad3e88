// Runs of neighbouring positions of a cycle, and how they are told.
#pragma once

#include "lib/quantity/format.hpp"
#include "lib/quantity/series.hpp"

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

inline std::string place_of(std::size_t k, const Axis& axis) { return format_quantity(axis.at[k], axis.unit, 5); }

}  // namespace loadpath::planar
