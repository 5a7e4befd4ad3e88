// Two rings pressed together by an interference: shaft and hub, or the tubes of a compound cylinder.
#pragma once

#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath {

/// Relative change of the contact radius per pressure, times the modulus of the ring: of the inner ring, then the
/// outer.
struct RingCompliances {
  double K_1, K_2;
};

/// Q_1: bore / contact diameter, Q_2: contact / outer diameter; `inner` and `outer` describe the rings.
template <class Input, class Tracer>
RingCompliances compliances_of_rings(const Input& in, double Q_1, double Q_2, const char* inner, const char* outer,
                                     Tracer& trace) {
  STEP(K_1, (1.0 + pow<2>(Q_1)) / (1.0 - pow<2>(Q_1)) - in.nu_1, inner);
  STEP(K_2, (1.0 + pow<2>(Q_2)) / (1.0 - pow<2>(Q_2)) + in.nu_2, outer);
  return {K_1, K_2};
}

}  // namespace loadpath
