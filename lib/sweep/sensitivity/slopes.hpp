// First derivatives at a point by differences, with estimates of their error.
//
// Differences over steps that are halved are extrapolated (Richardson), from both sides and from each; the entry of the
// scheme with the least estimated error is taken (Ridders 1982). A kink nearer than a 512th of the step counts as one
// at the point; others are not seen.
#pragma once

#include "lib/sweep/function.hpp"

#include <span>
#include <vector>

namespace loadpath::sweep {

struct Slope {
  enum class Kind {
    smooth,
    kink,       // the slopes of both sides differ: the value is their mean, the error half of their difference
    below,      // only from this side: the other is not available
    above,      // the same
    unsettled,  // a leap, or noise: the differences do not settle
    none        // not available on either side, or at the point; all numbers are NaN
  };
  Kind kind = Kind::none;
  double value, error;  // the error is estimated, and absolute
  double below, above;  // slopes on each side; NaN if not available
  double elasticity;    // relative change of the output to that of the input; NaN if the output is 0
};

struct Slopes {
  std::vector<double> base;   // the outputs
  std::vector<Slope> slopes;  // for each output those of all inputs
  std::size_t inputs = 0;
  [[nodiscard]] const Slope& at(std::size_t output, std::size_t input) const { return slopes[output * inputs + input]; }
};

/// Steps: the largest change of each input; empty, or 0: a hundredth of its value, or 0.01 where that is 0.
[[nodiscard]] Slopes slopes(Function& function, const std::vector<double>& base, std::span<const double> steps = {});

}  // namespace loadpath::sweep
