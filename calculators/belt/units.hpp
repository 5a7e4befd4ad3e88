// Units that belt drives are given in.
#pragma once

#include "lib/units.hpp"

namespace loadpath::belt {

using MassPerLength = decltype(Mass() / Length());
using Density = decltype(Mass() / SectionModulus());

inline constexpr Unit<Power> kW{"kW", from_si<Power>(1e3)};
inline constexpr Unit<AngularSpeed> rpm{"rpm", from_si<AngularSpeed>(pi / 30.0), 1};
inline constexpr Unit<AngularSpeed> Hz{"Hz", from_si<AngularSpeed>(1.0)};
inline constexpr Unit<Time> hour{"h", from_si<Time>(3600.0)};
inline constexpr Unit<MassPerLength> kg_per_m{"kg/m", from_si<MassPerLength>(1.0)};
inline constexpr Unit<SectionModulus> dm3{"dm^3", from_si<SectionModulus>(1e-3)};
inline constexpr Unit<Density> kg_per_m3{"kg/m^3", from_si<Density>(1.0)};

}  // namespace loadpath::belt
