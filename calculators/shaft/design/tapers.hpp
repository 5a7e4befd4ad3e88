// Where the tapers of a shaft are stressed most.
#pragma once

#include "calculators/shaft/design/model/stretches.hpp"

namespace loadpath::shaft {

/// The most stressed place of each taper, and the place of lowest fatigue strength if that is elsewhere.
CriticalPlaces weakest_of_tapers(const DesignInput& in);

}  // namespace loadpath::shaft
