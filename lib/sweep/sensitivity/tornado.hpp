// The change of an output when each input goes to its low and to its high value with the others fixed.
#pragma once

#include "lib/sweep/function.hpp"

#include <vector>

namespace loadpath::sweep {

struct Bar {
  std::size_t input = 0;
  double low = 0.0, high = 0.0;  // the output at the low and at the high value
  double swing = 0.0;            // the largest less the smallest of both and of the base; NaN if one is not available
  bool turns = false;            // the output at the base does not lie between both
};

struct Tornado {
  double base = 0.0;      // the output there
  std::vector<Bar> bars;  // those not available first, then by their span; equal ones in the order of the inputs
};

/// One for each output. Lows, highs and base have a value for each input.
[[nodiscard]] std::vector<Tornado> tornado(Function& function, const std::vector<double>& base,
                                           const std::vector<double>& lows, const std::vector<double>& highs);

}  // namespace loadpath::sweep
