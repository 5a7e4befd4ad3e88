// One width of one option of gear.sizing: its place in the ranking, and what gear.rating says of it.
#pragma once

#include "calculators/gear/sizing/found.hpp"
#include "calculators/gear/sizing/teeth.hpp"

#include <cmath>
#include <cstddef>
#include <tuple>

namespace loadpath::gear::sizing {

inline constexpr std::size_t most_rows = capacity_of<PairSizingTypes::Candidates>;

/// One width of an option, with what it is ranked by.
struct Point {
  std::size_t option = 0;
  double b = 0.0, first = 0.0, second = 0.0;

  bool operator<(const Point& other) const {
    return std::tie(first, second, option, b) < std::tie(other.first, other.second, other.option, other.b);
  }
};

/// Whether a limit of gear.rating rejects the pair.
template <class F>
bool is_outside(const F& limit, const RatingTypes::Result& r) {
  const double value = in_si(r.*limit.at) / in_si(limit.unit.one);
  return !limit.bounds.holds(value) && !(limit.where_set && std::isnan(value));
}

/// Of an option with its geometry; the width in mm.
Point point_of(const Input& in, std::size_t option, const PairResult& g, double b);

/// Whether only the load rejects the pair, so that a wider one may pass.
bool is_of_load(Failure failure);

/// Whether gear.rating takes the pair. If it does not, it does not take a wider one either.
bool is_admissible(const RatingTypes::Input& teeth);

/// A pair that gear.rating takes.
Found rated(const Input& in, const RatingTypes::Input& teeth);
/// A pair that breaks a rule of gear.rating.
Found unrated(const Input& in, const RatingTypes::Input& teeth);

}  // namespace loadpath::gear::sizing
