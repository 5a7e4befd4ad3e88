// Where tapers are weakest: within them, between the places where something else changes.
#pragma once

#include "calculators/shaft/design/bending.hpp"

namespace loadpath::shaft {

/// Of each taper the place where it is stressed most, and where it tires first if that is elsewhere.
Weakest weakest_of_tapers(const Design::Input& in);

}  // namespace loadpath::shaft
