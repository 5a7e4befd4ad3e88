// Lower bounds of the notch factors of shaft-hub connections, for typed factors.
#pragma once

#include "calculators/load/connection.hpp"
#include "lib/quantity/units.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

struct NotchFactors {
  double bending = 1.0, torsion = 1.0;
};

/// Fatigue notch factors of straight-sided splines, DIN 743-2, recalled.
inline NotchFactors factors_of_splines(Stress R_m) {
  const double R = in_si(R_m) / 1e6, torsion = std::exp(4.2e-7 * R * R);
  return {1.0 + 0.45 * (torsion - 1.0), torsion};
}

/// For steel of this tensile strength: [DIN743] part 2, table 1, less the scatter between tests and textbooks; the
/// values of [Shigley7] for keyways are 0.75 of it.
inline NotchFactors least_factors(Fastening fastening, Stress R_m) {
  constexpr double scatter = 0.7, scatter_of_splines = 0.95;
  const double share = in_si(R_m) / 1e9;
  const double key = 3.0 * std::pow(share, 0.38), fit = 2.7 * std::pow(share, 0.43);
  const auto bounded = [](double bending, double torsion, double part) {
    return NotchFactors{std::max(1.0, part * bending), std::max(1.0, part * torsion)};
  };
  switch (fastening) {
    case Fastening::key:
      return bounded(key, 0.56 * key + 0.1, scatter);
    case Fastening::two_keys:
      return bounded(1.15 * key, 1.15 * (0.56 * key + 0.1), scatter);
    case Fastening::press_fit:
      return bounded(fit, 0.65 * fit, scatter);
    case Fastening::spline: {
      const NotchFactors spline = factors_of_splines(R_m);
      return bounded(spline.bending, spline.torsion, scatter_of_splines);
    }
    default:
      return {};
  }
}

}  // namespace loadpath::shaft
