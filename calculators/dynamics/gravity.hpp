// The weight per mass of a calculator: given, by latitude and altitude, or the usual value.
//
// Normal gravity on the ellipsoid WGS 84 by Somigliana, and its series for heights. Density of the ground and the tides
// change it by less than 0.001 m/s^2 as a rule.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/motion_units.hpp"

#include <array>

namespace loadpath::dynamics {

template <class Input>
constexpr auto gravity_fields() {
  return Fields{
      Field{&Input::g, "g", m_per_s2, "weight per mass; omitted: by latitude, or 9.81 m/s^2"}
          .positive()
          .usually(9.78, 9.84)
          .customarily_at_least(9.7)
          .may_be_missing(),
      Field{&Input::latitude, "latitude", deg, "geographic latitude, determines g"}.within(-90, 90).may_be_missing(),
      Field{&Input::altitude, "altitude", m, "height above sea level, for g by latitude; omitted: 0"}
          .within(-12000, 100000)
          .usually(-500, 9000)
          .may_be_missing()};
}

template <class Input>
constexpr auto gravity_rules() {
  return std::array{Rule<Input>{[](const Input& in) { return !is_set(in.g) || !is_set(in.latitude); }, "g, latitude",
                                "the latitude determines g: give one of them"},
                    Rule<Input>{[](const Input& in) { return !is_set(in.altitude) || is_set(in.latitude); },
                                "altitude, latitude", "g at an altitude needs the latitude too"}};
}

template <class Input, class Tracer>
Acceleration gravity_of(const Input& in, Tracer& trace) {
  if (is_set(in.g)) return in.g;
  if (!is_set(in.latitude)) return trace.value("g", usual_gravity, "weight per mass, usual value, [B32]");
  STEP(s_phi, pow<2>(sin(in.latitude)), "square of the sine of the latitude");
  const char* const symbol = is_set(in.altitude) ? "g_0" : "g";
  const Acceleration g_0 = NAMED_STEP(
      symbol, 9.7803253359 * m_per_s2 * (1.0 + 0.00193185265241 * s_phi) / sqrt(1.0 - 0.00669437999013 * s_phi),
      "formula of Somigliana at sea level, [WGS84]");
  if (!is_set(in.altitude)) return g_0;
  const Length a_E = trace.value("a_E", 6378137.0 * m.one, "radius of the equator, [WGS84]");
  const double f_E = trace.value("f_E", 1.0 / 298.257223563, "flattening, [WGS84]");
  const double m_E = trace.value("m_E", 0.00344978650684, "centrifugal force over gravity at the equator, [WGS84]");
  STEP(k_h, in.altitude / a_E, "relative altitude");
  return NAMED_STEP("g", g_0 * (1.0 - 2.0 * (1.0 + f_E + m_E - 2.0 * f_E * s_phi) * k_h + 3.0 * pow<2>(k_h)),
                    "at the altitude, [WGS84]");
}

}  // namespace loadpath::dynamics
