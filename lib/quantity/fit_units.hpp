// Quantities of fits, beside those of lib/quantity/units.hpp: micrometres, differences of temperature, expansion. The
// temperature is the one base dimension of Boost.Units that the other header leaves out.
#pragma once

#include "lib/quantity/units.hpp"

#include <boost/units/systems/si/temperature.hpp>

namespace loadpath {

template <>
inline constexpr int detail::place_of<boost::units::temperature_base_dimension> = Dimension::temperature;

using Heating = boost::units::quantity<si::temperature>;  // a difference, never a point on the scale
using Expansion = decltype(1.0 / Heating());

inline constexpr Unit<Length> um{"um", from_si<Length>(1e-6)};
inline constexpr Unit<Heating> kelvin{"K", from_si<Heating>(1.0), 0, Kind::difference};
inline constexpr Unit<Expansion> per_kelvin{"1/K", from_si<Expansion>(1.0)};

}  // namespace loadpath
