// Whether a formula of the crank angle repeats after its period.
#pragma once

#include "lib/calculator/law_text.hpp"

#include <optional>

namespace loadpath::machine {

/// Where a formula differs from itself one period later: it leaps at the end of the period, or has another course in
/// the next one, as sin(phi/2) after 360 deg.
struct Unrepeated {
  bool leaps = false;
  double phi = 0.0;                // rad
  double here = 0.0, later = 0.0;  // values; of a leap before and after it
};

std::optional<Unrepeated> unrepeated(const Law& law, double period);

}  // namespace loadpath::machine
