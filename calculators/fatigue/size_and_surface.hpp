// Fatigue limit of a polished steel bar by DIN 743-3, and its reduction by section size and roughness by DIN 743-2:
// shared by the calculators that use these tables for those of Serensen, term for term, and by those that rate a
// section by the standard.
#pragma once

#include "lib/calculator/trace.hpp"
#include "lib/quantity/fit_units.hpp"
#include "lib/quantity/unit.hpp"
#include "lib/quantity/units.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::fatigue {

/// The place of a diameter on the logarithmic scale of sizes: 0 at 7.5 mm, 1 at 150 mm, and 1 beyond.
template <class Tracer>
double place_of_size(Length d, Tracer& trace) {
  return NAMED_STEP("x_d", d > 150.0 * mm ? 1.0 : log(d / (7.5 * mm)) / log(20.0),
                    "d from 7.5 to 150 mm on a logarithmic scale; it stays at 1 beyond, [DIN743]");
}

/// How much weaker than a small bar a thick one is in bending and torsion; tension knows no such effect.
struct SizeFactor {
  double x_d, K;
};
template <class Tracer>
SizeFactor size_factor(const char* symbol, Length d, const char* why, Tracer& trace) {
  const double x_d = place_of_size(d, trace);
  return {x_d, NAMED_STEP(symbol, 1.0 - 0.2 * x_d, why)};
}

/// K_F in tension and bending, of what is as rough as that.
template <class Tracer>
double roughness_factor(const char* symbol, Stress R_m, Length R_z, const char* why, Tracer& trace) {
  const double lg_R = trace.value("lg_R", std::log10(std::max(R_z / um, 1.0)), "lg of R_z in micrometres, 0 below 1");
  const double lg_S = trace.value("lg_S", std::log10(R_m / (20.0 * MPa)), "lg of R_m/20 MPa");
  return NAMED_STEP(symbol, 1.0 - 0.22 * lg_R * max(lg_S - 1.0, 0.0), why);
}

/// Fully reversed fatigue limit of a polished steel bar over its tensile strength, part 3.
struct PolishedBar {
  double tension, bending, torsion;
};
inline constexpr PolishedBar polished_bar{0.4, 0.5, 0.3};

}  // namespace loadpath::fatigue
