// Bounds on the typed factors of a rolling bearing. e, Y and Y_0 follow from the contact angle and are therefore
// related.
#pragma once

#include "calculators/bearing/rolling_kind.hpp"
#include "lib/calculator/bound.hpp"

#include <array>

namespace loadpath::bearing {

/// Lower bounds of e Y and of Y_0/Y.
struct LeastFactors {
  double e_Y = unset<double>, Y_0_over_Y = unset<double>;
};
/// Minimum over 570 bearings in the catalogues of [Koyo] and SKF, rounded down. [ISO281]: e Y = 0.6 for single-row
/// tapered roller bearings, 1 for two rows.
constexpr LeastFactors least_factors(Kind kind) {
  switch (kind) {
    case Kind::angular_contact_ball:
      return {0.5, 0.4};
    case Kind::angular_contact_pair:
      return {0.95, 0.5};
    case Kind::self_aligning_ball:
      return {0.95, 0.6};
    case Kind::tapered_roller:
      return {0.58, 0.5};
    case Kind::tapered_pair:
    case Kind::spherical_roller:
      return {0.95, 0.59};
    default:
      return {};
  }
}

template <class Input>
double least_X(const Input& in) {
  return radial_factor(in.kind);
}
template <class Input>
double least_Y(const Input& in) {
  return least_factors(in.kind).e_Y / in.e;
}
template <class Input>
double least_Y_0(const Input& in) {
  return least_factors(in.kind).Y_0_over_Y * in.Y;
}

/// In millions of revolutions, the least usual life in hours.
template <class Input>
double least_life(const Input& in) {
  constexpr Time least = from_si<Time>(100.0 * 3600.0);
  return in_si(least * in.n) / (2.0 * pi) / 1e6;
}

/// Smaller factors are not conservative.
template <class Input>
constexpr auto factor_bounds() {
  return std::array{Bound<Input>{"X", "the kind of bearing", &least_X<Input>}.least(),
                    Bound<Input>{"Y", "e of bearings of this kind", &least_Y<Input>}.least(),
                    Bound<Input>{"Y_0", "Y of bearings of this kind", &least_Y_0<Input>}.least(),
                    Bound<Input>{"L_m", "100 h at this speed", &least_life<Input>}.least()};
}

}  // namespace loadpath::bearing
