// The one place that inserts positions: where the requested ones miss a feature of a law of a load, of a drive or of
// a cam between them, its maximum, its minimum or a corner.
#pragma once

#include "calculators/mechanism/cycle/schedule.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::planar {

struct Between {
  std::vector<double> places;  // places of all positions, as schedule_of takes them
  std::size_t inserted = 0;
  std::string missed;      // the laws that are not shown for all that: "the course 'k'"
  std::size_t needed = 0;  // how many positions would show them; 0: more than can be counted
};

/// Without positions between them where there is one position, or none is missing.
Between places_between(const Mechanism::Input& in, const mechanism::Model& model, bool redundant,
                       const Assembled& assembled);

/// Whether a cam may need positions between the requested ones: its laws run over a few of them.
bool has_short_segments(const Mechanism::Input& in);

}  // namespace loadpath::planar
