// A section of a shaft against fatigue: what its notch does, by Peterson's charts or by the notch factors that DIN 743
// measured, what the part lasts, and how the schools see it.
#pragma once

#include "calculators/shaft/design/design.hpp"

namespace loadpath::shaft {

/// What changes at a place; no notch: null.
struct There {
  std::size_t node = 0;
  const Notched* notch = nullptr;
  Name name;
};

/// The piece on each side of a place; the same at the ends of the shaft.
struct Sides {
  const Piece& left;
  const Piece& right;
  [[nodiscard]] const Piece& thinner() const { return left.d < right.d ? left : right; }
  [[nodiscard]] Length larger() const { return max(left.d, right.d); }
};

template <class Tracer>
Safety safety_of(const Design::Input& in, const There& there, const Sides& sides, const Section& p, Tracer& trace);

}  // namespace loadpath::shaft
