// The value of one input at which an output reaches a target.
#pragma once

#include "lib/sweep/function.hpp"

#include <cstdint>
#include <vector>

namespace loadpath::sweep {

struct Goal {
  std::size_t input = 0;
  double from = 0.0, to = 0.0;  // from < to
  std::size_t output = 0;
  double target = 0.0;
  std::size_t points = 257;  // at which the range is looked at, 2 at least
};

/// A point where the output equals the target, or jumps across it.
struct Solution {
  enum class Kind {
    crossing,  // to rounding: `within` is the final width of the bracket
    touching,  // without crossing; to a millionth of the neighbouring deviation of the output from the target
    stretch,   // from `at` to `to` at every point that was looked at
    leap       // past it: the output has the target on neither side
  };
  Kind kind = Kind::crossing;
  double at = 0.0, to = 0.0;
  double value = 0.0;   // value of the output at `at`
  double within = 0.0;  // error bound of the position
};

struct SeekResult {
  std::vector<Solution> solutions;  // in order; two closer than the points apart may be missed
  double nearest = 0.0;             // place nearest to the target; NaN if there is no value
  double value = 0.0;               // there
  std::uint64_t evaluations = 0;
};

/// The other inputs keep the values of `base`. Brackets by points over the range and at the edges of missing values;
/// roots by TOMS 748 of Boost.Math.
[[nodiscard]] SeekResult seek(Function& function, const std::vector<double>& base, const Goal& goal);

}  // namespace loadpath::sweep
