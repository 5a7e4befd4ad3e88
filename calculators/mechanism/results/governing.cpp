#include "calculators/mechanism/results/governing.hpp"

#include "calculators/mechanism/results/output.hpp"

#include <cmath>

namespace loadpath::planar {

std::size_t governing_position(const Cycle& cycle, const account::Account& account) {
  for (const auto& e : account.results) {
    if (!is_drive_effort(e.path)) continue;
    const Extreme peak = largest(e.value);
    if (!std::isnan(peak.value) && cycle.has_forces(peak.nearest)) return peak.nearest;
  }
  std::size_t first = 0;
  while (first < cycle.positions.size() && !cycle.has_forces(first)) ++first;
  return first;
}

}  // namespace loadpath::planar
