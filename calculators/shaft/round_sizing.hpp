// The least diameter of a round shaft by strength: solid, with the bore as a ratio, or with the bore as a size.
#pragma once

#include "calculators/shaft/section.hpp"
#include "lib/calculator/trace.hpp"

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

/// The minimum diameter with the torsional section modulus W_t, under the caller's symbol. In bending W = W_t/2.
template <class Tracer>
Length size_for_modulus(const char* symbol, SectionModulus W_t, const Bore& bore, const SizingReasons& why,
                        Tracer& trace) {
  if (is_set(bore.chi)) return NAMED_STEP(symbol, cbrt(16.0 * W_t / (pi * (1.0 - pow<4>(bore.chi)))), why.ratio);
  if (!is_set(bore.d_bore)) return NAMED_STEP(symbol, cbrt(16.0 * W_t / pi), why.solid);
  return trace.value(symbol, diameter_for_modulus(W_t, bore.d_bore), why.size);
}

}  // namespace loadpath::shaft
