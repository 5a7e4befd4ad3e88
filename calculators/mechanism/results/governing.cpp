#include "calculators/mechanism/results/governing.hpp"

#include <cmath>

namespace loadpath::planar {

std::size_t governing_position(const Cycle& cycle, const Results& results) {
  for (const auto& line : results) {
    if (!is_effort(line.kind())) continue;
    const Extreme peak = largest(line.entry->value);
    if (!std::isnan(peak.value) && cycle.has_forces(peak.nearest)) return peak.nearest;
  }
  std::size_t first = 0;
  while (first < cycle.positions.size() && !cycle.has_forces(first)) ++first;
  return first;
}

}  // namespace loadpath::planar
