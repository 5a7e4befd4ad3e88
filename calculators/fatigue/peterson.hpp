// Stress concentration of shoulders and round grooves of solid round bars, on the net section: the cubic fits of
// Peterson's charts, each within its range of height over radius.
#pragma once

#include "lib/quantity/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace loadpath::fatigue {

/// A fit between low and high h/r: C_i = p + q sqrt(h/r) + u h/r, K = C_1 + C_2 s + C_3 s^2 + C_4 s^3, s = 2 h/D.
struct Fit {
  double low, high;
  std::array<std::array<double, 3>, 4> C;
};

// [Peterson] charts 3.10, 3.12 (shoulders in bending, in torsion), 2.41, 2.47 (grooves).
inline constexpr std::array shoulder_in_bending{
    Fit{0.1, 2.0, {{{0.947, 1.206, -0.131}, {0.022, -3.405, 0.915}, {0.869, 1.777, -0.555}, {-0.810, 0.422, -0.260}}}},
    Fit{2.0,
        20.0,
        {{{1.232, 0.832, -0.008}, {-3.813, 0.968, -0.260}, {7.423, -4.868, 0.869}, {-3.839, 3.070, -0.600}}}}};
inline constexpr std::array shoulder_in_torsion{Fit{
    0.25, 4.0, {{{0.905, 0.783, -0.075}, {-0.437, -1.969, 0.553}, {1.557, 1.073, -0.578}, {-1.061, 0.171, 0.086}}}}};
inline constexpr std::array groove_in_bending{
    Fit{0.25,
        2.0,
        {{{0.594, 2.958, -0.520}, {0.422, -10.545, 2.692}, {0.501, 14.375, -4.486}, {-0.613, -6.573, 2.177}}}},
    Fit{2.0,
        50.0,
        {{{0.965, 1.926, 0.000}, {-2.773, -4.414, -0.017}, {4.785, 4.681, 0.096}, {-1.995, -2.241, -0.074}}}}};
inline constexpr std::array groove_in_torsion{
    Fit{0.25,
        2.0,
        {{{0.966, 1.056, -0.022}, {-0.192, -4.037, 0.674}, {0.808, 5.321, -1.231}, {-0.567, -2.364, 0.566}}}},
    Fit{2.0,
        50.0,
        {{{1.089, 0.924, 0.018}, {-1.504, -2.141, -0.047}, {2.486, 2.289, 0.091}, {-1.056, -1.104, -0.059}}}}};

struct Concentration {
  double K;
  double place;  // position of h/r within the fits: 0 minimum, 1 maximum, on a logarithmic scale
};

/// By one fit, at y = h/r and s = 2 h/D.
inline double by_fit(const Fit& fit, double y, double s) {
  double K = 0.0;
  for (std::size_t i = fit.C.size(); i-- > 0;) K = K * s + fit.C[i][0] + fit.C[i][1] * std::sqrt(y) + fit.C[i][2] * y;
  return K;
}

/// Factor of a notch of height h and radius r on the larger diameter D. A fit below 1 is invalid and gives 1; where
/// two fits meet the larger counts, for they differ by a percent there.
inline Concentration concentration(std::span<const Fit> fits, Length h, Length r, Length D) {
  constexpr double seam = 1e-6;
  const double y = h / r, s = 2.0 * h / D;
  double K = 1.0;
  for (const Fit& fit : fits) {
    const bool first = &fit == &fits.front(), last = &fit == &fits.back();
    if ((first || y >= (1.0 - seam) * fit.low) && (last || y <= (1.0 + seam) * fit.high))
      K = std::max(K, by_fit(fit, y, s));
  }
  return {K, std::log(y / fits.front().low) / std::log(fits.back().high / fits.front().low)};
}

}  // namespace loadpath::fatigue
