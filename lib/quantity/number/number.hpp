// The number of a quantity: 30, -5, 1e6, 2·10^6, 1 200, 2,5, 1-1/2. Ambiguous numbers are refused.
#pragma once

#include "lib/text/issue.hpp"

#include <cstddef>
#include <string_view>

namespace loadpath {

struct Number {
  double value = 0.0;
  std::size_t end = 0;  // end of its text
};

/// The number that starts at `at`.
Outcome<Number> read_number(std::string_view text, std::size_t at);

/// Whether a value is a number to calculate with: zero, or within the range of full precision.
bool is_normal_or_zero(double value);

}  // namespace loadpath
