// Factors that modify the rating life: a_1 for reliability, a_ISO for lubricant film and contamination.
#pragma once

#include "calculators/bearing/rolling_kind.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/quantity/drive_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::bearing {

using Viscosity = decltype(from_si<Area>(1.0) / from_si<Time>(1.0));
inline constexpr Unit<Viscosity> mm2_per_s{"mm^2/s", from_si<Viscosity>(1e-6)};

/// The Weibull distribution of three parameters behind the a_1 of [ISO281] (recalled; it meets that table): slope, and
/// the share of L_10 before which none fails.
inline constexpr double weibull_slope = 1.5, weibull_least = 0.05;

inline double a_1_of(double reliability) {
  const double failed = std::log(1.0 / reliability) / std::log(1.0 / 0.9);
  return weibull_least + (1.0 - weibull_least) * std::pow(failed, 1.0 / weibull_slope);
}
/// The reliability with which a life is reached, given over the one of 90 %.
inline double reliability_of(double life) {
  if (!(life > weibull_least)) return 1.0;
  return std::pow(0.9, std::pow((life - weibull_least) / (1.0 - weibull_least), weibull_slope));
}

/// Range of the viscosity ratio, and the largest factor, [ISO281-aISO].
inline constexpr double least_kappa = 0.1, most_kappa = 4.0, most_a_ISO = 50.0;

/// The viscosity that a bearing of this pitch diameter needs at this speed, [ISO281-aISO].
inline Viscosity reference_viscosity(AngularSpeed speed, Length pitch_diameter) {
  const double n = speed / rpm, D_pw = pitch_diameter / mm;
  return (n < 1000.0 ? 45000.0 * std::pow(n, -0.83) : 4500.0 * std::pow(n, -0.5)) / std::sqrt(D_pw) * mm2_per_s.one;
}

/// a_ISO by the viscosity ratio and e_C C_u/P, [ISO281-aISO].
inline double a_ISO_of(Kind kind, double kappa, double clean_limit) {
  struct Curve {
    double below, ball, roller, power;
  };
  constexpr std::array curves{Curve{0.4, 2.2649, 1.3993, 0.054381}, Curve{1.0, 1.9987, 1.2348, 0.19087},
                              Curve{most_kappa, 1.9987, 1.2348, 0.071739}};
  const double k = std::min(kappa, most_kappa);
  const Curve& curve = k < curves[0].below ? curves[0] : k < curves[1].below ? curves[1] : curves[2];
  const bool balls = has_balls(kind);
  // Axial loads divide the limit by 3 (balls) and 2.5 (rollers): recalled.
  const double axial = !takes_axial_alone(kind) ? 1.0 : balls ? 3.0 : 2.5;
  const double film = balls ? std::pow(2.5671 - curve.ball / std::pow(k, curve.power), 0.83)
                            : 1.5859 - curve.roller / std::pow(k, curve.power);
  const double rest = 1.0 - film * std::pow(clean_limit / axial, balls ? 1.0 / 3.0 : 0.4);
  return rest > 0.0 ? std::min(0.1 * std::pow(rest, balls ? -9.3 : -9.185), most_a_ISO) : most_a_ISO;
}

/// Inputs of the factors.
template <class Input>
constexpr auto life_inputs() {
  return Fields{Field{&Input::R, "R", ratio, "required reliability, 0.9 to 0.9995, replaces a_1"}
                    .within(0.9, 0.9995)
                    .may_be_missing(),
                Field{&Input::kappa, "kappa", ratio, "viscosity ratio nu/nu_1, for a_ISO"}
                    .at_least(least_kappa)
                    .usually(0.1, 10)
                    .may_be_missing(),
                Field{&Input::nu, "nu", mm2_per_s,
                      "kinematic viscosity of the lubricant at operating temperature, replaces kappa"}
                    .positive()
                    .usually(2, 1000)
                    .may_be_missing(),
                Field{&Input::e_C, "e_C", ratio,
                      "contamination factor: 1 extreme cleanliness, 0.8 to 0.6 high, 0.6 to 0.5 normal, 0.5 to 0.3 "
                      "slight, 0.3 to 0.1 typical, below 0.1 severe contamination"}
                    .within(0, 1)
                    .may_be_missing(),
                Field{&Input::C_u, "C_u", kN, "fatigue load limit, manufacturer's value"}
                    .positive()
                    .usually(1e-3, 1e4)
                    .from("bearing", "C_u")
                    .where_it_has()};
}

/// Whether lubricant and contamination are given.
template <class Input>
constexpr bool has_film(const Input& in) {
  return is_set(in.kappa) || is_set(in.nu);
}
template <class Input>
constexpr Applies film_is_given(const Input& in) {
  return has_film(in) ? Applies::yes : Applies::unseen;
}

}  // namespace loadpath::bearing
