// The place of a shell where something is largest.
#pragma once

#include "lib/numerics/magnitude.hpp"
#include "lib/numerics/peak.hpp"

#include <cmath>
#include <cstddef>

namespace loadpath::vessel {

using numerics::Peak;
using numerics::peak_between;

/// The largest f >= 0 over the places of a shape, NaN where one is; between them too where the shape is continuous: its
/// places are then in order, and among them are all at which the load changes.
template <class Shape, class Function>
Peak largest_over(const Shape& shape, const Function& f) {
  Peak best;
  const std::size_t count = shape.places();
  if (count == 1) return {shape.place(0), f(shape.place(0))};
  for (std::size_t i = 0; i < count; ++i) {
    const Peak here{shape.place(i), f(shape.place(i))};
    if (std::isnan(here.f)) return here;
    if (numerics::exceeds(here.f, best.f)) best = here;
  }
  if constexpr (requires { Shape::continuous; }) {
    constexpr double worth = 0.99, flat = 1e-12;  // shares: a lower peak stays lower; no peak, but rounding
    const double low = worth * best.f;
    Peak before, here{shape.place(0), f(shape.place(0))};
    for (std::size_t i = 0; i < count; ++i) {
      const Peak after = i + 1 < count ? Peak{shape.place(i + 1), f(shape.place(i + 1))} : Peak{here.t};
      const double height = here.f * (1.0 - flat);
      if (here.f >= low && before.f < height && after.f <= here.f) {
        const Peak between = peak_between(f, i == 0 ? here.t : before.t, after.t);
        if (between.f > best.f * (1.0 + flat)) best = between;
      }
      before = here, here = after;
    }
  }
  return best;
}

}  // namespace loadpath::vessel
