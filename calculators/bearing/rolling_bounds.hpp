// Bounds on the typed factors, speed and minimum load of a rolling bearing. e, Y and Y_0 follow from the contact angle
// and are therefore related.
#pragma once

#include "calculators/bearing/rolling_kind.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>
#include <cmath>

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
/// Catalogues: pitch diameters from 5.5 mm sqrt(C/kN) on, and speeds up to 1.4e6 mm/min over them; only spindle
/// bearings run faster.
template <class Input>
double highest_limiting_speed(const Input& in) {
  constexpr double speed_of_1_kN = 2.5e5;
  return in_si(speed_of_1_kN * rpm.one) * std::sqrt(1e3 * N.one / in.C);
}
/// Manufacturers' formulas give less than the customary 0.01 C at high speeds, a tenth of it at least.
template <class Input>
double least_minimum_load(const Input& in) {
  constexpr double share = 0.001;
  return in_si(share * in.C);
}

/// Smaller factors are not conservative.
template <class Input>
constexpr auto rolling_bounds() {
  return std::array{
      Bound<Input>{"n_max", "bearings of this load rating", &highest_limiting_speed<Input>},
      Bound<Input>{"P_min", "a tenth of the customary minimum load of 0.01 C", &least_minimum_load<Input>}.least(),
      Bound<Input>{"X", "the kind of bearing", &least_X<Input>}.least(),
      Bound<Input>{"Y", "e of bearings of this kind", &least_Y<Input>}.least(),
      Bound<Input>{"Y_0", "Y of bearings of this kind", &least_Y_0<Input>}.least(),
      Bound<Input>{"c_i", "bearings with Y of ISO 281; 0.47 is of those with K", [](const Input&) { return 0.5; }}
          .least(),
      Bound<Input>{"L_m", "100 h at this speed", &least_life<Input>}.least()};
}

}  // namespace loadpath::bearing
