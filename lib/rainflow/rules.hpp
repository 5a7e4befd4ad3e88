// The rules for counting cycles.
#pragma once

#include "lib/rainflow/comparisons.hpp"
#include "lib/text/issue.hpp"

#include <optional>

namespace loadpath::rainflow {

/// The condition for closing loops: lib/rainflow/methods.hpp.
enum class Method { four_point, hcm, astm };

/// The treatment of turning points that close no loop.
enum class Residue {
  ignore,
  half_cycles,  // each range is half a cycle
  repeated,     // repeating history: cycles of the residue's second pass count, ISO 12110-2
  astm,         // as in ASTM E1049, in its order; half cycles too
};

struct Rules {
  Method method = Method::four_point;
  Residue residue = Residue::half_cycles;
  double gate = 0.0;    // ranges below are not counted, in the unit of the series
  bool placed = false;  // whether the places of a cycle's begin and end are recorded
  bool blocks = true;   // whether loops that close at once are taken out first; never with places
  Instructions instructions = best_instructions();
};

/// The contradiction between rules: the residue of ASTM E1049 is in half cycles, and HCM discards the start that a
/// repetition returns to (count_periodic does not); an omission level below zero.
std::optional<Fault> contradiction(const Rules& rules);

}  // namespace loadpath::rainflow
