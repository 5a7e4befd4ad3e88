// The pairs of teeth of the range of gear.sizing, before their width and load.
#pragma once

#include "calculators/gear/rating/wheels.hpp"
#include "calculators/gear/sizing/types.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace loadpath::gear::sizing {

/// Series I of ISO 54, as in the table of modules, in mm.
inline constexpr std::array module_series{1.0, 1.25, 1.5,  2.0,  2.5,  3.0,  4.0,  5.0,  6.0,
                                          8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0};
/// Face widths: R20, rounded as in the table of preferred numbers, per decade.
inline constexpr std::array r20{1.0,  1.12, 1.25, 1.4, 1.6, 1.8, 2.0, 2.24, 2.5, 2.8,
                                3.15, 3.55, 4.0,  4.5, 5.0, 5.6, 6.3, 7.1,  8.0, 9.0};
/// Face widths in modules in common use: thinner discs and wider gears are not tried (gear.pair warns beyond 30).
inline constexpr double least_psi_m = 6.0, most_psi_m = 30.0;
/// Profile shift coefficients in common use, as in the fields of gear.pair.
inline constexpr double least_x = -0.8, most_x = 1.2;

/// A module of one pair of tooth numbers, with its profile shifts.
struct Option {
  std::size_t numbers = 0;  // position in `Range::numbers`
  double m = unset<double>, x_1 = unset<double>, x_2 = unset<double>;
};

/// Every pair of teeth of the range. Numbers of teeth and helix angle are kept once for all their modules.
struct Range {
  std::vector<RatingTypes::Input> numbers;
  std::vector<Option> options;  // those of one pair of numbers are adjacent, by ascending module

  /// Input of gear.rating without a face width.
  [[nodiscard]] RatingTypes::Input teeth(std::size_t option) const;
};
Range range_of(const PairSizingTypes::Input& in);

/// Circles and profile shifts of a pair.
PairResult laid_out(const RatingTypes::Input& teeth);

/// Face widths of a pair, in mm, ascending.
std::vector<double> widths_of(const PairSizingTypes::Input& in, double m_n, double d_1);

}  // namespace loadpath::gear::sizing
