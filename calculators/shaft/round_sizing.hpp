// The least diameter of a round shaft by strength: solid, with the bore as a ratio, or with the bore as a size.
#pragma once

#include "calculators/shaft/section.hpp"
#include "lib/trace.hpp"

namespace loadpath::shaft {

/// A bore as a ratio or as a size; solid where neither is set.
struct Bore {
  double chi = unset<double>;
  Length d_bore = unset<Length>;
};

/// Why each of the formulas holds, in the words of the calculator that sizes.
struct SizingReasons {
  const char *solid, *ratio, *size;
};

/// d_t, at which W_t = M_t/tau_adm.
template <class Tracer>
Length size_by_torsion(Moment M_t, Stress tau_adm, const Bore& bore, const SizingReasons& why, Tracer& trace) {
  const auto chi = bore.chi;
  if (is_set(chi)) {
    STEP(d_t, cbrt(16.0 * M_t / (pi * tau_adm * (1.0 - pow<4>(chi)))), why.ratio);
    return d_t;
  }
  if (is_set(bore.d_bore)) {
    const Length d = diameter_for_modulus(M_t / tau_adm, bore.d_bore);
    trace.value("d_t", d, why.size);
    return d;
  }
  STEP(d_t, cbrt(16.0 * M_t / (pi * tau_adm)), why.solid);
  return d_t;
}

/// d_v, at which W = M_v/sigma_adm.
template <class Tracer>
Length size_by_equivalent(Moment M_v, Stress sigma_adm, const Bore& bore, const SizingReasons& why, Tracer& trace) {
  const auto chi = bore.chi;
  if (is_set(chi)) {
    STEP(d_v, cbrt(32.0 * M_v / (pi * sigma_adm * (1.0 - pow<4>(chi)))), why.ratio);
    return d_v;
  }
  if (is_set(bore.d_bore)) {
    const Length d = diameter_for_modulus(2.0 * M_v / sigma_adm, bore.d_bore);
    trace.value("d_v", d, why.size);
    return d;
  }
  STEP(d_v, cbrt(32.0 * M_v / (pi * sigma_adm)), why.solid);
  return d_v;
}

}  // namespace loadpath::shaft
