// The search of gear.sizing: every pair of its range, lightest first or closest first, by the checks and limits of
// gear.rating.
#pragma once

#include "calculators/gear/sizing/found.hpp"

namespace loadpath::gear::sizing {

/// Nominal torque of gear 1.
template <class Tracer>
Moment torque_of(const Input& in, Tracer& trace) {
  if (!is_set(in.P)) return in.T_1;
  return NAMED_STEP("T_1", in.P / abs(in.n_1), "torque from the power, nominal");
}

/// The best pair, or where none passes the nearest one; `tried` is zero where the range has no pair.
Found search_for(const Input& in, Result& r);

double measure_of(const Candidate& c, By by);

}  // namespace loadpath::gear::sizing
