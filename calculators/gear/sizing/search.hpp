// The search of gear.sizing: every pair of its range, lightest first or closest first, by the checks and limits of
// gear.rating.
#pragma once

#include "calculators/gear/sizing/types.hpp"

namespace loadpath::gear::sizing {

using Input = PairSizingTypes::Input;
using Result = PairSizingTypes::Result;
using Candidate = PairSizingTypes::Candidate;
using Failure = PairSizingTypes::Failure;
using By = PairSizingTypes::By;

/// Nominal torque of gear 1.
template <class Tracer>
Moment torque_of(const Input& in, Tracer& trace) {
  if (!is_set(in.P)) return in.T_1;
  return NAMED_STEP("T_1", in.P / abs(in.n_1), "torque from the power, nominal");
}

/// What keeps a pair from passing: limits that it leaves, its largest check, and the mode that rejects it.
struct Lack {
  int limits = 0;
  double check = 0.0;
  Failure failure = Failure::none;

  [[nodiscard]] bool none() const { return failure == Failure::none; }
  [[nodiscard]] bool less_than(const Lack& other) const {
    return limits != other.limits ? limits < other.limits : check < other.check;
  }
};

/// A pair with its input of gear.rating.
struct Found {
  RatingTypes::Input teeth;
  Candidate row;
  Lack lack;
};

/// The best pair, or where none passes the one that lacks least; `tried` is zero where the range has no pair.
Found search_for(const Input& in, Result& r);

double measure_of(const Candidate& c, By by);

}  // namespace loadpath::gear::sizing
