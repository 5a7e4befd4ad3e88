// A lower bound of the utilisation of a pair of tooth numbers at every module and face width, from one rating: the load
// factors are 1 or more, and the other factors of stress and strength are bounded by their values of one module.
#pragma once

#include "calculators/gear/sizing/teeth.hpp"

#include <cmath>

namespace loadpath::gear::sizing {

struct LoadBound {
  double flank = 0.0, root = 0.0;  // for a module and a face width of 1 mm
  double most_m = HUGE_VAL;        // limits of the tooth form or the velocity reject larger modules, in mm

  /// No pair of module m and face width b, in mm, has a smaller largest check.
  [[nodiscard]] double at(double m, double b) const;
};

/// Whether teeth of all modules have one shape, so that one rating bounds all of them.
bool has_one_shape(const PairSizingTypes::Input& in);

/// From the largest module of the numbers: the film of the lubricant is strongest there.
LoadBound bound_of(const RatingTypes::Input& largest);

}  // namespace loadpath::gear::sizing
