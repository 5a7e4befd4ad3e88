// Quantities and units of drives. Those of lib/quantity/units.hpp are included by almost every file; these are not.
#pragma once

#include "lib/quantity/units.hpp"

namespace loadpath {

using LineDensity = decltype(Mass() / Length());  // mass per length of a chain or belt
using Density = decltype(Mass() / SectionModulus());
using PressureSpeed = decltype(Stress() * Speed());  // pv value of plain bearings

inline constexpr Unit<AngularSpeed> rpm{"rpm", from_si<AngularSpeed>(pi / 30.0), 1};
inline constexpr Unit<Power> kW{"kW", from_si<Power>(1e3)};
inline constexpr Unit<LineDensity> kg_per_m{"kg/m", from_si<LineDensity>(1.0)};
inline constexpr Unit<AngularSpeed> Hz{"Hz", from_si<AngularSpeed>(1.0)};
inline constexpr Unit<Time> hour{"h", from_si<Time>(3600.0)};
inline constexpr Unit<SectionModulus> dm3{"dm^3", from_si<SectionModulus>(1e-3)};
inline constexpr Unit<Density> kg_per_m3{"kg/m^3", from_si<Density>(1.0)};
inline constexpr Unit<PressureSpeed> MPa_m_per_s{"MPa*m/s", from_si<PressureSpeed>(1e6)};

using std::pow;  // overload for numbers, next to pow<n> for quantities

}  // namespace loadpath
