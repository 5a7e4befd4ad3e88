// The effective length factor beta = s/l of a column: the cases of its ends, on the chosen basis, or the
// characteristic equation for supports between the ends.
#pragma once

#include "calculators/column/codes/choices.hpp"
#include "calculators/column/member/stability.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath::column {

/// Meanings of effective length factors: a column buckles in its first mode, unless that is prevented.
inline constexpr auto factor_of_first_mode = "an effective length factor of the first buckling mode";
inline constexpr auto factor_of_higher_mode = "an effective length factor of a higher buckling mode";

/// The ends of a case as springs; both hinged for Ends::unsaid.
Bar bar_of(Ends ends);

/// The factor of a case; NaN for Ends::unsaid.
inline double length_factor(Ends ends, Basis basis) {
  struct Case {
    double exact, text, recommended;
  };
  static constexpr std::array cases{Case{unset<double>, unset<double>, unset<double>},
                                    Case{1.0, 1.0, 1.0},
                                    Case{2.0, 2.0, 2.1},
                                    Case{0.699155659642841, 0.7, 0.80},  // pi over the first root of tan u = u
                                    Case{0.5, 0.5, 0.65},
                                    Case{1.0, 1.0, 1.2},
                                    Case{2.0, 2.0, 2.0}};
  static_assert(cases.size() == choices_of(Ends{}).size());
  const auto& [exact, text, recommended] = cases[static_cast<std::size_t>(ends)];
  return basis == Basis::exact ? exact : basis == Basis::text ? text : recommended;
}

inline const char* length_factor_reason(Basis basis) {
  switch (basis) {
    case Basis::exact:
      return "theoretical effective length factor for these end conditions";
    case Basis::text:
      return "as the textbook rounds it, [B25]";
    case Basis::recommended:
      return "recommended for real ends, [AISC360]";
  }
  return "";
}

}  // namespace loadpath::column
