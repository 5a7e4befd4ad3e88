// The shape of a shaft: cylinders and tapers, their sections along it, and the ends at which two of them meet.
#pragma once

#include "calculators/shaft/design/model/input.hpp"
#include "calculators/shaft/parts/ring.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace loadpath::shaft {

inline Length right_diameter(const Piece& p) { return is_set(p.d_2) ? p.d_2 : p.d; }
inline bool is_taper(const Piece& p) { return right_diameter(p) != p.d; }
inline Length thickest(const Piece& p) { return max(p.d, right_diameter(p)); }
inline Length thinnest(const Piece& p) { return min(p.d, right_diameter(p)); }
/// Slope of its surface to the axis, positive where it widens to the right.
inline double slope_of(const Piece& p) { return in_si(right_diameter(p) - p.d) / (2.0 * in_si(p.l)); }

inline Ring ring_at(const Piece& p, Length from_its_left) {
  if (!is_taper(p)) return {p.d, p.d_bore};
  const double t = std::min(std::max(in_si(from_its_left) / in_si(p.l), 0.0), 1.0);
  return {(1.0 - t) * p.d + t * p.d_2, p.d_bore};
}

/// The section on each side of a place; the same within a piece, and at the ends of the shaft.
struct Sides {
  Ring left, right;
  [[nodiscard]] const Ring& thinner() const { return left.d < right.d ? left : right; }
  [[nodiscard]] Length larger() const { return max(left.d, right.d); }
};

/// The piece that a place is on; behind the end the last.
std::size_t index_of_piece(const DesignInput& in, Length x);
/// Where a piece begins.
Length start_of(const DesignInput& in, std::size_t piece);
Length length_of(const DesignInput& in);
Mass mass_of(const DesignInput& in);

/// The logarithm of how its wall grows along a stretch.
inline double growth_of(const Piece& p, double from, double to) {
  const auto wall = [&](double x) {
    const Ring ring = ring_at(p, from_si<Length>(x));
    return in_si(ring.d - ring.d_bore);
  };
  return std::log(wall(to) / wall(from));
}

/// Calls with the ends of each part of a stretch of a taper, from the left end of the piece; the wall grows along each
/// by the same ratio.
template <class Take>
void for_each_part(const Piece& p, double from, double to, double parts, const Take& take) {
  const double growth = growth_of(p, from, to);
  const auto end = [&](double k) {
    const double share = growth == 0.0 ? k / parts : std::expm1(growth * k / parts) / std::expm1(growth);
    return k < parts ? from + (to - from) * share : to;
  };
  for (double k = 0.0; k < parts; ++k) take(end(k), end(k + 1.0));
}

}  // namespace loadpath::shaft
