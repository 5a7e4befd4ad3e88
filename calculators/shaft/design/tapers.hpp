// Where the tapers of a shaft are stressed most.
#pragma once

#include "calculators/shaft/design/model/stretches.hpp"

namespace loadpath::shaft {

/// Of each taper the place where it is stressed most, and where it tires first if that is elsewhere.
Weakest weakest_of_tapers(const DesignInput& in);

}  // namespace loadpath::shaft
