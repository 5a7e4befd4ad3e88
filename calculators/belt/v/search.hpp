// The search of belt.v_sizing: every pair of pulleys that is made, with the nearest belt, by the checks of belt.v.
#pragma once

#include "calculators/belt/v/sizing_types.hpp"

#include <cmath>
#include <limits>

namespace loadpath::belt {

/// How far a drive is from passing: the limits of belt.v that it leaves, and its largest check.
struct Shortfall {
  int limits = 0;
  double check = 0.0;

  [[nodiscard]] bool none() const { return limits == 0 && check <= 1.0; }
  [[nodiscard]] bool less_than(const Shortfall& other) const {
    return limits != other.limits ? limits < other.limits : check < other.check;
  }
};

/// The drive nearest to passing, where none passes.
struct Nearest {
  V::Input drive;
  Shortfall shortfall{std::numeric_limits<int>::max(), 0.0};
};

/// The input of belt.v that corresponds to a drive of the list; diameters, length and section are still open.
V::Input drive_of(const VSizingTypes::Input& in);

/// Every pair of pulleys of a section that meets the speed: counts, ranks, and keeps the nearest.
void try_section(const VSection& section, const VSizingTypes::Input& in, VSizingTypes::Result& r, Nearest& nearest);

/// Ranking key of a drive.
double measure_of(const VSizingTypes::Candidate& c, VSizingTypes::Rank rank);

inline double share_off(double value, double wanted) { return std::abs(value / wanted - 1.0); }

}  // namespace loadpath::belt
