// The kinds of rolling bearings: life exponent, factors that belong to the kind, and the axial load that it takes.
#pragma once

#include "lib/calculator/field.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace loadpath::bearing {

enum class Kind {
  unstated,
  deep_groove_ball,
  angular_contact_ball,
  angular_contact_pair,
  self_aligning_ball,
  cylindrical_roller_NU,
  cylindrical_roller_NJ,
  cylindrical_roller_NUP,
  needle_roller,
  tapered_roller,
  tapered_pair,
  spherical_roller,
  thrust_ball,
  thrust_roller
};

constexpr auto choices_of(Kind) {
  return std::array{
      ChoiceName<Kind>{Kind::unstated, "not_given", "not given (refused)", "unstated"},
      ChoiceName<Kind>{Kind::deep_groove_ball, "deep_groove_ball", "deep groove ball bearing, single row"},
      ChoiceName<Kind>{Kind::angular_contact_ball, "angular_contact_ball",
                       "angular contact ball bearing, single row: axial load in one direction"},
      ChoiceName<Kind>{Kind::angular_contact_pair, "angular_contact_pair",
                       "paired angular contact ball bearings, face to face or back to back; C and C_0 of the pair"},
      ChoiceName<Kind>{Kind::self_aligning_ball, "self_aligning_ball", "self-aligning ball bearing"},
      ChoiceName<Kind>{Kind::cylindrical_roller_NU, "cylindrical_roller_NU",
                       "cylindrical roller bearing NU or N: a ring without ribs, no axial load"},
      ChoiceName<Kind>{Kind::cylindrical_roller_NJ, "cylindrical_roller_NJ",
                       "cylindrical roller bearing NJ: ribs in one direction"},
      ChoiceName<Kind>{Kind::cylindrical_roller_NUP, "cylindrical_roller_NUP",
                       "cylindrical roller bearing NUP, or NJ with HJ: ribs in both directions"},
      ChoiceName<Kind>{Kind::needle_roller, "needle_roller", "needle roller bearing: no axial load"},
      ChoiceName<Kind>{Kind::tapered_roller, "tapered_roller",
                       "tapered roller bearing, single row: axial load in one direction"},
      ChoiceName<Kind>{Kind::tapered_pair, "tapered_pair",
                       "paired tapered roller bearings, face to face or back to back; C and C_0 of the pair"},
      ChoiceName<Kind>{Kind::spherical_roller, "spherical_roller", "spherical roller bearing, two rows"},
      ChoiceName<Kind>{Kind::thrust_ball, "thrust_ball", "thrust ball bearing: axial load only, one direction"},
      ChoiceName<Kind>{Kind::thrust_roller, "thrust_roller",
                       "thrust bearing with cylindrical or needle rollers: axial load only, one direction"}};
}

/// Loads that the shaft has its bearing take, as shaft.design says.
enum class Holds { unsaid, radial, both };

constexpr auto choices_of(Holds) {
  return std::array{ChoiceName<Holds>{Holds::unsaid, "", "not given"},
                    ChoiceName<Holds>{Holds::radial, "radial", "radial forces: non-locating bearing"},
                    ChoiceName<Holds>{Holds::both, "both", "radial and axial forces: locating bearing"}};
}

constexpr bool has_balls(Kind kind) {
  return kind == Kind::deep_groove_ball || kind == Kind::angular_contact_ball || kind == Kind::angular_contact_pair ||
         kind == Kind::self_aligning_ball || kind == Kind::thrust_ball;
}
constexpr bool takes_axial_alone(Kind kind) { return kind == Kind::thrust_ball || kind == Kind::thrust_roller; }
constexpr bool takes_radial_alone(Kind kind) {
  return kind == Kind::cylindrical_roller_NU || kind == Kind::needle_roller;
}
/// One row at an angle: a radial load makes an axial one, which the opposed bearing carries.
constexpr bool at_an_angle(Kind kind) { return kind == Kind::angular_contact_ball || kind == Kind::tapered_roller; }
constexpr bool takes_one_way(Kind kind) {
  return at_an_angle(kind) || takes_axial_alone(kind) || kind == Kind::cylindrical_roller_NJ;
}
constexpr bool bears_on_ribs(Kind kind) {
  return kind == Kind::cylindrical_roller_NJ || kind == Kind::cylindrical_roller_NUP;
}
/// Two rows, of which an axial load within e loads one more: P = F_r + Y_1 F_a.
constexpr bool has_two_rows(Kind kind) {
  return kind == Kind::angular_contact_pair || kind == Kind::self_aligning_ball || kind == Kind::tapered_pair ||
         kind == Kind::spherical_roller;
}

/// X of a kind beyond e, [Koyo], [LYC-bearings], [Honghui]; none where it depends on the contact angle.
constexpr double radial_factor(Kind kind) {
  switch (kind) {
    case Kind::deep_groove_ball:
      return 0.56;
    case Kind::self_aligning_ball:
      return 0.65;
    case Kind::cylindrical_roller_NJ:
    case Kind::cylindrical_roller_NUP:
      return 0.92;
    case Kind::tapered_roller:
      return 0.4;
    case Kind::tapered_pair:
    case Kind::spherical_roller:
      return 0.67;
    default:
      return unset<double>;
  }
}

/// X_0 of a kind, [ISO76] as [Koyo] has it.
constexpr double static_radial_factor(Kind kind) {
  if (kind == Kind::deep_groove_ball) return 0.6;
  return at_an_angle(kind) ? 0.5 : 1.0;
}

/// Y_0 of a kind: 0 if the static load is only the radial one; none if it is in the manufacturer's table.
constexpr double static_axial_factor(Kind kind) {
  if (kind == Kind::deep_groove_ball) return 0.5;
  return takes_radial_alone(kind) || bears_on_ribs(kind) ? 0.0 : unset<double>;
}

/// Bounds of C_0/C of a kind: above with a margin of a quarter or so, below loosely, where C_0 is not overrated.
struct RatioOfRatings {
  double least, most;
};
/// From 1,600 bearings in the catalogues of [Koyo] and SKF; needles and thrust rollers recalled. The static rating of
/// balls grows with the bearing size: C in kN.
inline RatioOfRatings ratio_of_ratings(Kind kind, double C) {
  const double of_balls = 1.15 * std::pow(C / 10.0, 0.15);
  switch (kind) {
    case Kind::deep_groove_ball:
    case Kind::angular_contact_ball:
      return {0.25, of_balls};
    case Kind::angular_contact_pair:
      return {0.35, 1.25 * of_balls};
    case Kind::self_aligning_ball:
      return {0.15, 0.65};
    case Kind::cylindrical_roller_NU:
    case Kind::cylindrical_roller_NJ:
    case Kind::cylindrical_roller_NUP:
      return {0.4, 2.6};
    case Kind::needle_roller:
      return {0.4, 3.5};
    case Kind::tapered_roller:
      return {0.4, 2.7};
    case Kind::tapered_pair:
      return {0.4, 3.2};
    case Kind::spherical_roller:
      return {0.4, 2.5};
    case Kind::thrust_ball:
      return {0.5, 5.5};
    case Kind::thrust_roller:
      return {0.5, 14.0};
    case Kind::unstated:
      break;
  }
  return {0.0, std::numeric_limits<double>::infinity()};
}

/// f_0 F_a/C_0, e and Y of deep groove ball bearings of normal clearance, [ISO281] as [Koyo] prints it.
struct DeepGroove {
  double f, e, Y;
};
inline constexpr std::array deep_groove{
    DeepGroove{0.172, 0.19, 2.30}, DeepGroove{0.345, 0.22, 1.99}, DeepGroove{0.689, 0.26, 1.71},
    DeepGroove{1.03, 0.28, 1.55},  DeepGroove{1.38, 0.30, 1.45},  DeepGroove{2.07, 0.34, 1.31},
    DeepGroove{3.45, 0.38, 1.15},  DeepGroove{5.17, 0.42, 1.04},  DeepGroove{6.89, 0.44, 1.00}};

/// Straight between the rows; the first one holds below it, the last one above.
constexpr DeepGroove deep_groove_at(double f) {
  if (!(f > deep_groove.front().f)) return deep_groove.front();
  for (std::size_t i = 1; i < deep_groove.size(); ++i) {
    const DeepGroove &a = deep_groove[i - 1], &b = deep_groove[i];
    if (f > b.f) continue;
    const double w = (f - a.f) / (b.f - a.f);
    return {f, a.e + w * (b.e - a.e), a.Y + w * (b.Y - a.Y)};
  }
  return deep_groove.back();
}

}  // namespace loadpath::bearing
