// Quantities in texts that people read: "Hoist for 5 t", "900 N m", "250 strokes a minute".
#pragma once

#include "lib/quantity/dimension.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

struct Said {
  std::string text;  // "5 t"
  double si = 0.0;
  double last_digit = 0.0;  // what one in the last digit counts, SI
  Dimension dimension;      // of an angular velocity without its angle
};

/// The quantities in a text, in its order. A number next to a letter, "C45", has no unit of its own.
std::vector<Said> quantities_in(std::string_view text);

}  // namespace loadpath::project
