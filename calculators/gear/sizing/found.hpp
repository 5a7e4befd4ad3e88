// What gear.sizing keeps of a pair that it tried, and which of two pairs is closer to passing.
#pragma once

#include "calculators/gear/sizing/types.hpp"

namespace loadpath::gear::sizing {

using Input = PairSizingTypes::Input;
using Result = PairSizingTypes::Result;
using Candidate = PairSizingTypes::Candidate;
using Failure = PairSizingTypes::Failure;
using By = PairSizingTypes::By;

/// What keeps a pair from passing: limits that it leaves, its largest check, and the mode that rejects it.
struct Shortfall {
  int limits = 0;
  double check = 0.0;
  Failure failure = Failure::none;

  [[nodiscard]] bool none() const { return failure == Failure::none; }
  [[nodiscard]] bool less_than(const Shortfall& other) const {
    return limits != other.limits ? limits < other.limits : check < other.check;
  }
};

/// A pair with its input of gear.rating.
struct Found {
  RatingTypes::Input teeth;
  Candidate row;
  Shortfall shortfall;
};

}  // namespace loadpath::gear::sizing
