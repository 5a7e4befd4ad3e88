// The pressure of a liquid at rest inside a vessel.
#pragma once

#include "calculators/vessel/membrane.hpp"
#include "lib/quantity/gravity.hpp"

namespace loadpath::vessel {

inline constexpr Acceleration gravity = standard_gravity * m_per_s2;

/// At the height z above the lowest place; zero above the surface.
template <class Tracer>
Stress head(const Liquid& liquid, Length z, Tracer& trace) {
  const Acceleration g_n = trace.value("g_n", gravity, "standard acceleration of free fall");
  trace.value("z", z, "height of the position");
  return NAMED_STEP("p_l", liquid.rho * g_n * max(liquid.h_l - z, 0.0 * liquid.h_l), "head of the liquid");
}

}  // namespace loadpath::vessel
