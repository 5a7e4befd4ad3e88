// A section of a shaft against fatigue: what its notch does, by Peterson's charts or by the notch factors that DIN 743
// measured, what the part lasts, and how the schools see it.
#pragma once

#include "calculators/fatigue/din743/nominal.hpp"
#include "calculators/shaft/design/model/input.hpp"
#include "calculators/shaft/design/model/result.hpp"
#include "calculators/shaft/design/model/turn.hpp"
#include "lib/calculator/trace.hpp"

namespace loadpath::shaft {

/// Node and notch at a place of change; no notch: null.
struct ChangePlace {
  std::size_t node = 0;
  const Notched* notch = nullptr;
  Name name;
};

/// Moduli of a section; a cross hole takes a strip off it.
struct Moduli {
  Area A;
  SectionModulus W, W_t;
};
template <class Tracer>
Moduli moduli_of(const Section& p, const Notched* notch, Tracer& trace) {
  if (notch != nullptr && notch->kind == Notch::cross_hole) {
    const Length r = trace.value("r", notch->r, "of the hole");
    return {fatigue::net_area_at_hole("A", p.d, r, trace), fatigue::net_modulus_at_hole("W", 32.0, p.d, r, trace),
            fatigue::net_modulus_at_hole("W_t", 16.0, p.d, r, trace)};
  }
  STEP(A, pi / 4.0 * (p.d * p.d - p.d_bore * p.d_bore), "area");
  STEP(W, pi / 32.0 * (pow<4>(p.d) - pow<4>(p.d_bore)) / p.d, "section modulus in bending");
  STEP(W_t, 2.0 * W, "the modulus in torsion is twice that in bending");
  return {A, W, W_t};
}

/// `swings`: what varies over a turn at points of the circumference, of which the weakest decides; none: loads stay in
/// space, and the shaft turns.
template <class Tracer>
Safety safety_of(const DesignInput& in, const ChangePlace& there, const Sides& sides, const Section& p,
                 std::span<const Swings> swings, Tracer& trace);

}  // namespace loadpath::shaft
