// Units that only belt drives are given in.
#pragma once

#include "lib/drive_units.hpp"

namespace loadpath::belt {

using Density = decltype(Mass() / SectionModulus());

inline constexpr Unit<AngularSpeed> Hz{"Hz", from_si<AngularSpeed>(1.0)};
inline constexpr Unit<Time> hour{"h", from_si<Time>(3600.0)};
inline constexpr Unit<SectionModulus> dm3{"dm^3", from_si<SectionModulus>(1e-3)};
inline constexpr Unit<Density> kg_per_m3{"kg/m^3", from_si<Density>(1.0)};

}  // namespace loadpath::belt
