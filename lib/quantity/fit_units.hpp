// Units of fits: micrometres, temperature differences, expansion; and temperatures.
#pragma once

#include "lib/quantity/units.hpp"

namespace loadpath {

inline constexpr Unit<Length> um{"um", from_si<Length>(1e-6)};
inline constexpr Unit<Heating> kelvin{"K", from_si<Heating>(1.0), 0, Kind::difference};
inline constexpr Unit<Heating> scale_of_heat{"K", from_si<Heating>(1.0), 0, Kind::temperature};  // above absolute zero
inline constexpr Unit<Expansion> per_kelvin{"1/K", from_si<Expansion>(1.0)};

}  // namespace loadpath
