// SI units in the notation of other programs.
#pragma once

#include "lib/quantity/dimension.hpp"

#include <string>

namespace loadpath::exports {

/// The SI unit by its name where it has one: Pa, not kg/(m*s^2); empty for a number.
std::string unit_name(const Dimension& dimension);

}  // namespace loadpath::exports
