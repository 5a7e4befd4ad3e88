// The round section of a shaft, solid or bored: what torsion and bending share.
#pragma once

#include "lib/quantity/units.hpp"

namespace loadpath::shaft {

/// The outer diameter at which a bore of given size leaves the section modulus W_t = pi (d^4 - d_bore^4) / (16 d).
/// Newton from above: the function is convex there, so the sequence falls to the root.
inline Length diameter_for_modulus(SectionModulus W_t, Length d_bore) {
  const double w = 16.0 * in_si(W_t) / pi, b = in_si(d_bore);
  double d = b + numerics::cube_root(w);
  for (int i = 0; i < 60; ++i) {
    const double next = d - (d * d * d * d - b * b * b * b - w * d) / (4.0 * d * d * d - w);
    if (!(next < d)) break;
    d = next;
  }
  return from_si<Length>(d);
}

/// An alternative that the user may leave open: the bore as a size or as a ratio, the first that is set.
inline Length bore_of(Length d_bore, double chi, Length d) {
  if (is_set(d_bore)) return d_bore;
  return is_set(chi) ? chi * d : 0.0 * d;
}

}  // namespace loadpath::shaft
