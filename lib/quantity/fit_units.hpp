// What fits are given in: micrometres, differences of temperature, expansion.
#pragma once

#include "lib/quantity/units.hpp"

namespace loadpath {

inline constexpr Unit<Length> um{"um", from_si<Length>(1e-6)};
inline constexpr Unit<Heating> kelvin{"K", from_si<Heating>(1.0), 0, Kind::difference};
inline constexpr Unit<Expansion> per_kelvin{"1/K", from_si<Expansion>(1.0)};

}  // namespace loadpath
