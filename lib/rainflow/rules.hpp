// By which rules cycles are counted.
#pragma once

#include "lib/rainflow/comparisons.hpp"
#include "lib/text/issue.hpp"

#include <optional>

namespace loadpath::rainflow {

/// Which loops close: lib/rainflow/methods.hpp.
enum class Method { four_point, hcm, astm };

/// What becomes of the turning points that close nothing.
enum class Residue {
  ignore,
  half_cycles,  // each range is half a cycle
  repeated,     // the history repeats: what closes when the residue comes once more is counted, after ISO 12110-2
  astm,         // as ASTM E1049 counts it, in its order; half cycles too
};

struct Rules {
  Method method = Method::four_point;
  Residue residue = Residue::half_cycles;
  double gate = 0.0;    // ranges below are not counted, in the unit of the series
  bool placed = false;  // whether it is told where a cycle begins and ends
  bool blocks = true;   // whether loops that close at once are taken out first; never with places
  Instructions instructions = best_instructions();
};

/// What of the rules contradicts: the residue of ASTM E1049 is in half cycles, and HCM has forgotten the start that a
/// repetition comes back to (count_periodic has not); a gate below zero.
std::optional<Fault> contradiction(const Rules& rules);

}  // namespace loadpath::rainflow
